// Numbered mazes, generated on request, in three disjoint splits for training, validation and test.
//
// A maze belongs to a split by its content, not by its seed: a hash of its size, walls, start and goals decides, and a
// maze of another split is skipped. So no training maze is in the test set, even for sizes so small that the generator
// repeats mazes.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "labmouse/maze/generators/generator.hpp"

namespace labmouse {

/// Six of eight mazes are for training, one for validation (choice among trained models), one for the final test.
enum class Split : std::uint8_t { train, validation, test };

inline constexpr std::array all_splits = {Split::train, Split::validation, Split::test};

constexpr std::string_view name_of(Split split) {
  constexpr std::array<std::string_view, 3> names = {"train", "validation", "test"};
  return names[static_cast<unsigned>(split)];
}

/// The split of a maze. It depends on size, walls, start and goals only.
Split split_of(const Maze& maze);

struct MazeFamily {
  const Generator* generator = nullptr;
  Size size{16, 16};
  int loops = 0;  ///< as in GeneratorOrder
  Split split = Split::train;
  /// Mazes have the numbers 0 to count - 1. With count 0, any 64-bit number is a maze.
  std::uint64_t count = 0;
};

/// Why there is no such family (a message for the user), or empty. Either the generator refuses it, or no maze of so
/// small a size is in the split.
std::string_view refuses(const MazeFamily& family);

/// The maze of that number, in a family for which refuses() returns an empty text. Equal numbers give equal mazes in
/// all versions.
Maze maze_of(const MazeFamily& family, std::uint64_t number);

}  // namespace labmouse
