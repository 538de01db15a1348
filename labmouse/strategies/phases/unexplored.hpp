// What the report of `phases` calls unexplored: a cell of which not all four sides have been seen.
#pragma once

#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {

/// The cells on both sides of the given walls.
inline CellSet cells_beside(const WallSet& walls) {
  CellSet cells;
  walls.for_each([&](Wall wall) {
    cells.insert(wall.cell);
    cells.insert(neighbour(wall.cell, wall.side));
  });
  return cells;
}

/// The cells that have a side that has not been seen; the border is known from birth.
inline CellSet unexplored_cells(const Knowledge& knowledge) { return cells_beside(knowledge.unknown()); }

}  // namespace labmouse
