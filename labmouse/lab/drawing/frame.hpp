// Coordinates of an SVG picture in pixels: integers, y downwards, the maze's north at the top.
#pragma once

#include "labmouse/grid/cell.hpp"

namespace labmouse::drawing {

struct Point {
  int x = 0;
  int y = 0;

  friend bool operator==(const Point&, const Point&) = default;
  Point moved(int right, int down) const { return {x + right, y + down}; }
};

/// The place of a maze in its picture.
struct Frame {
  static constexpr int cell = 40;
  /// Walls are a tenth of a cell thick.
  static constexpr int wall = cell / 10;

  /// Width of the visible border of a coloured square under another one.
  static constexpr int rim = cell / 8;

  Size size;
  /// The north-west corner of the maze.
  Point origin;

  /// The north-west corner of a cell; the cell may lie outside.
  Point corner(Cell at) const { return origin.moved(at.x * cell, (size.height - 1 - at.y) * cell); }
  Point centre(Cell at) const { return corner(at).moved(cell / 2, cell / 2); }
  int right() const { return origin.x + size.width * cell; }
  int bottom() const { return origin.y + size.height * cell; }
};

}  // namespace labmouse::drawing
