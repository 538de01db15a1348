// The eight symmetries of the square, applied to cells, walls and mazes.
#pragma once

#include <array>

#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// A reflection (east and west change places) or none, then a clockwise turn by 0 to 3 quarters.
struct Symmetry {
  bool mirrored = false;
  int quarters = 0;

  friend constexpr bool operator==(Symmetry, Symmetry) = default;
};

/// The identity first.
inline constexpr std::array<Symmetry, 8> all_symmetries = {
    {{false, 0}, {false, 1}, {false, 2}, {false, 3}, {true, 0}, {true, 1}, {true, 2}, {true, 3}}};

/// The size after the symmetry was applied.
constexpr Size transformed(Size size, Symmetry symmetry) {
  return symmetry.quarters % 2 == 0 ? size : Size{size.height, size.width};
}

constexpr Heading transformed(Heading heading, Symmetry symmetry) {
  return turned(symmetry.mirrored ? turned(Heading::north, -static_cast<int>(heading)) : heading, symmetry.quarters);
}

/// The new position of a cell of a maze of that size.
constexpr Cell transformed(Cell cell, Size size, Symmetry symmetry) {
  if (symmetry.mirrored) cell = {size.width - 1 - cell.x, cell.y};
  for (int turn = 0; turn < symmetry.quarters; ++turn) {
    cell = {cell.y, size.width - 1 - cell.x};
    size = {size.height, size.width};
  }
  return cell;
}

/// The inner walls of a maze of that size.
WallSet transformed(const WallSet& walls, Size size, Symmetry symmetry);

/// The maze with its walls, its start and heading, and its goals.
Maze transformed(const Maze& maze, Symmetry symmetry);

/// The open walls of a maze, in the one of its eight symmetric forms that sorts first.
struct CanonicalWalls {
  Size size;
  WallSet open;

  friend bool operator==(const CanonicalWalls&, const CanonicalWalls&) = default;
  /// A total order, the same on every platform.
  friend bool operator<(const CanonicalWalls& a, const CanonicalWalls& b);
};

/// Equal for two mazes if and only if a symmetry maps the walls of one to those of the other. Start and goals are
/// ignored: collections hold mirrored mazes that kept their start in the south-west corner.
CanonicalWalls canonical_walls(const Maze& maze);

}  // namespace labmouse
