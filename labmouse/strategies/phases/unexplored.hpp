// Unexplored cells, as defined by the source of `phases`: not all four sides have been seen.
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

/// The cells with an unseen side; the border counts as seen from the beginning.
inline CellSet unexplored_cells(const Knowledge& knowledge) { return cells_beside(knowledge.unknown()); }

}  // namespace labmouse
