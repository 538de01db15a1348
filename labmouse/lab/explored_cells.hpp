// What an exploration saw of a maze, read off its record.
#pragma once

#include <vector>

#include "labmouse/contest/record.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// Cells of one exploration; visited lies in discovered, and discovered in reachable.
struct ExploredCells {
  /// Visited, or shown by a reading: the cells of the corridors to the left, ahead and to the right.
  CellSet discovered;
  /// Stood in or crossed.
  CellSet visited;
  /// Those that one can walk to from the start: the whole of which the others are shares.
  CellSet reachable;

  friend bool operator==(const ExploredCells&, const ExploredCells&) = default;
};

/// The cells that the exploration in a record of this maze came to know. The speed run adds nothing.
ExploredCells explored_cells(const Maze& maze, const RunRecord& record);

/// How often the exploration came into each cell, by size.index(cell), those that it drove through among them; the
/// start counts once more.
std::vector<int> exploration_visits(Size size, const RunRecord& record);

}  // namespace labmouse
