// Walls, each under a unique name.
//
// Two cells share a wall, so it could be named by either. Its name is always the north or the east side of a cell. This
// holds for the border, too: the wall west of (0,0) is the east side of (-1,0), a cell outside of the maze.
//
//          o---o   <- Wall{(x,y), north}
//          |   |   <- Wall{(x,y), east} on the right, Wall{(x-1,y), east} on the left
//          o---o   <- Wall{(x,y-1), north}
#pragma once

#include <compare>

#include "labmouse/grid/cell.hpp"
#include "labmouse/grid/heading.hpp"

namespace labmouse {

/// A place where a wall may stand. Make it with wall_at: then `side` is north or east and equal walls compare equal.
struct Wall {
  Cell cell;
  Heading side = Heading::north;

  friend constexpr bool operator==(Wall, Wall) = default;
  friend constexpr auto operator<=>(Wall, Wall) = default;
};

/// The wall on a side of a cell, under its one name.
/// @param cell one of its two cells; it may lie just outside of the maze.
/// @param side where the wall is, seen from the cell.
/// @return `side` is north or east.
constexpr Wall wall_at(Cell cell, Heading side) {
  if (side == Heading::north || side == Heading::east) return {cell, side};
  return {neighbour(cell, side), opposite(side)};
}

/// Whether the wall belongs to the border of a maze, so that at most one of its two cells is inside.
/// @param wall as wall_at() makes it.
/// @param size of the maze.
constexpr bool on_border(Wall wall, Size size) {
  return !size.contains(wall.cell) || !size.contains(neighbour(wall.cell, wall.side));
}

}  // namespace labmouse
