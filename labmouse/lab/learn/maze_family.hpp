// Endless numbered mazes, made when they are asked for, in three splits that share no maze.
//
// A maze belongs to a split by its content, not by its seed: a hash of its walls, start and goals says which, and a
// maze of another split is passed over. So what a learner trained on is never in its test, even where mazes are so
// small that chance makes the same one twice.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "labmouse/maze/generators/generator.hpp"

namespace labmouse {

/// Six mazes of eight are for training, one is for choosing among what was trained, one is for the last test.
enum class Split : std::uint8_t { train, validation, test };

inline constexpr std::array all_splits = {Split::train, Split::validation, Split::test};

constexpr std::string_view name_of(Split split) {
  constexpr std::array<std::string_view, 3> names = {"train", "validation", "test"};
  return names[static_cast<unsigned>(split)];
}

/// The split of a maze. Nothing but size, walls, start and goals decides it.
Split split_of(const Maze& maze);

struct MazeFamily {
  const Generator* generator = nullptr;
  Size size{16, 16};
  int loops = 0;  ///< as in GeneratorOrder
  Split split = Split::train;
  /// Mazes have the numbers 0 to count - 1; 0: any 64-bit number.
  std::uint64_t count = 0;
};

/// Why there is no such family (a line for the user), or empty: the generator refuses, or so small a size has no maze
/// in the split.
std::string_view refuses(const MazeFamily& family);

/// The maze of that number; only of families that are not refused. Equal numbers give equal mazes for ever.
Maze maze_of(const MazeFamily& family, std::uint64_t number);

}  // namespace labmouse
