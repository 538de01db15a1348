// Which mazes a study counts, and in which fold each of them is held out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "labmouse/lab/races/world.hpp"

namespace labmouse {

/// A maze that has the walls of another one, turned or mirrored or as they are; both by name.
struct Duplicate {
  std::string name;
  std::string same_as;
};

/// The mazes that count, and those left out, all in the order of their names.
struct MazeSelection {
  std::vector<NamedMaze> mazes;
  std::vector<Duplicate> duplicates;
  std::vector<std::string> routeless;  ///< their goals cannot be reached
};

/// Leaves out mazes in which no mouse can score in that world and, of those with the same walls, all but the first by
/// name: a maze that was learned from is no test, from whatever side it is seen. Start and goals make no difference
/// there.
MazeSelection select_mazes(std::vector<NamedMaze> mazes, const World& world);

/// For each of the names the fold (0 to folds - 1) of that maze. Folds differ by at most one maze. The deal depends on
/// the seed and on the names without their folders, and not on their order (of equal ones, the folders decide).
std::vector<int> deal_folds(const std::vector<std::string>& names, int folds, std::uint64_t seed);

}  // namespace labmouse
