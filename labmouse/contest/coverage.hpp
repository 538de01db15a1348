// How much of a maze a search run saw and walked: a function of its record.
#pragma once

#include <vector>

#include "labmouse/contest/record.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// Cells that a search run came to know; visited lies in discovered.
struct ExploredCells {
  /// Visited cells, and those that a reading showed a way into: all cells of the corridors that were seen.
  CellSet discovered;
  /// Cells that the mouse stood in or drove through.
  CellSet visited;
  /// Those that can be reached from the start: the whole of which the others are shares.
  CellSet reachable;

  friend bool operator==(const ExploredCells&, const ExploredCells&) = default;
};

/// Shares, 0 to 1, of the cells that can be reached from the start, at the end of the search run.
struct Coverage {
  double discovered = 0.0;
  double visited = 0.0;

  friend constexpr bool operator==(const Coverage&, const Coverage&) = default;
};

/// The cells that a step came into on its way to the next pose, those that it drove through among them; none where it
/// stayed, or was a reset. Cells that lie outside of a maze of that size are left out.
std::vector<Cell> entered_cells(const StepRecord& step, const Pose& next, Size size);

/// The cells that the search run came into, in their order and as often as it did, the start first. Those that it
/// drove through are among them. Cells of a record that lie outside of a maze of that size are left out.
std::vector<Cell> explored_way(const RunRecord& record, Size size);

/// The cells of a search run: of all of its steps, with the reading of the one that reset it. The speed run adds
/// none.
ExploredCells explored_cells(const RunRecord& record, const Maze& maze);

/// Their shares; at least one cell must be reachable.
Coverage coverage_of(const ExploredCells& cells);
Coverage coverage_of(const RunRecord& record, const Maze& maze);
/// The same, where the reachable cells (at least one) of the maze are known already.
Coverage coverage_of(const RunRecord& record, Size size, const CellSet& reachable);

}  // namespace labmouse
