// Selects the mazes of a study and assigns them to folds.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "labmouse/lab/races/world.hpp"

namespace labmouse {

/// The names of a maze and of an earlier one with the same walls, possibly rotated or mirrored.
struct Duplicate {
  std::string name;
  std::string same_as;
};

/// The selected mazes and those left out, all in the order of their names.
struct MazeSelection {
  std::vector<NamedMaze> mazes;
  std::vector<Duplicate> duplicates;
  std::vector<std::string> routeless;  ///< their goals cannot be reached
};

/// Leaves out mazes in which no mouse can score in that world. Of mazes with the same walls it keeps only the first by
/// name, because a maze is no test for a mouse that has learned from a copy. Rotation, mirroring, start and goals make
/// no difference.
MazeSelection select_mazes(std::vector<NamedMaze> mazes, const World& world);

/// The fold of each maze, 0 to folds - 1. The sizes of folds differ by at most one. The assignment depends on the seed
/// and on the names without folders, but not on the order of names; folders only break ties.
std::vector<int> deal_folds(const std::vector<std::string>& names, int folds, std::uint64_t seed);

}  // namespace labmouse
