// Distances in a maze without walls.
#pragma once

#include <algorithm>
#include <cstdlib>

#include "labmouse/mouse/distance.hpp"

namespace labmouse {

/// Manhattan distance in cells.
inline int manhattan(Cell a, Cell b) { return std::abs(a.x - b.x) + std::abs(a.y - b.y); }

/// The same to the nearest of some cells; unreachable if there are none.
inline int manhattan_to(const CellSet& cells, Cell from) {
  int nearest = unreachable;
  cells.for_each([&](Cell cell) { nearest = std::min(nearest, manhattan(from, cell)); });
  return nearest;
}

}  // namespace labmouse
