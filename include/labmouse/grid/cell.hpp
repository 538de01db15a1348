// Cells of a maze, and its size.
//
//      y
//      2 | (0,2) (1,2) (2,2)
//      1 | (0,1) (1,1) (2,1)
//      0 | (0,0) (1,0) (2,0)      (0,0) is the cell in the south-west corner;
//        +------------------ x    x counts eastwards, y northwards.
#pragma once

#include <compare>
#include <cstdint>

namespace labmouse {

/// The longest side of a maze, in cells.
inline constexpr int max_side = 64;

/// One square of a maze by its column x and row y. It may lie outside of the maze; functions say which cells they
/// accept.
struct Cell {
  std::int8_t x = 0;
  std::int8_t y = 0;

  constexpr Cell() = default;
  /// A cell.
  /// @param column x, -128 to 127.
  /// @param row y, -128 to 127.
  constexpr Cell(int column, int row) : x(static_cast<std::int8_t>(column)), y(static_cast<std::int8_t>(row)) {}

  friend constexpr bool operator==(Cell, Cell) = default;
  /// Total order: row by row from the south, in a row from the west.
  friend constexpr std::strong_ordering operator<=>(Cell a, Cell b) {
    if (const auto rows = a.y <=> b.y; rows != 0) return rows;
    return a.x <=> b.x;
  }
};

/// Width and height of a maze in cells, each 1 to max_side.
struct Size {
  int width = 0;
  int height = 0;

  friend constexpr bool operator==(Size, Size) = default;

  /// Whether both sides are 1 to max_side.
  constexpr bool valid() const { return width >= 1 && width <= max_side && height >= 1 && height <= max_side; }
  /// Whether a cell lies inside a maze of this size.
  /// @param cell any cell.
  constexpr bool contains(Cell cell) const { return cell.x >= 0 && cell.x < width && cell.y >= 0 && cell.y < height; }
  /// The number of cells.
  constexpr int area() const { return width * height; }

  /// Position of a cell in the total order, row by row from the south; cell_at() is its inverse.
  /// @param cell inside.
  /// @return 0 to area() - 1.
  constexpr int index(Cell cell) const { return cell.y * width + cell.x; }
  /// The cell at a position of the total order; the inverse of index().
  /// @param index 0 to area() - 1.
  constexpr Cell cell_at(int index) const { return {index % width, index / width}; }
};

}  // namespace labmouse
