// Computes from a record how much of a maze a search run saw and visited.
#pragma once

#include <vector>

#include "labmouse/contest/record.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// Cells known after a search run; visited is a subset of discovered.
struct ExploredCells {
  /// Visited cells, and all cells of the corridors that were seen.
  CellSet discovered;
  /// Cells that the mouse stood in or drove through.
  CellSet visited;
  /// Cells that can be reached from the start; Coverage counts only these.
  CellSet reachable;

  friend bool operator==(const ExploredCells&, const ExploredCells&) = default;
};

/// Shares, 0 to 1, of the cells that can be reached from the start, at the end of the search run.
struct Coverage {
  double discovered = 0.0;
  double visited = 0.0;

  friend constexpr bool operator==(const Coverage&, const Coverage&) = default;
};

/// The cells that a step entered on its way, including those driven through.
/// @param step pose and action.
/// @param next the pose after the step.
/// @param size cells outside of it are left out.
/// @return in order; empty if the mouse stayed, or for a reset.
std::vector<Cell> entered_cells(const StepRecord& step, const Pose& next, Size size);

/// The cells that the search run entered, including those driven through.
/// @param record of a contest in steps.
/// @param size cells outside of it are left out.
/// @return in order and with repetitions, from the start.
std::vector<Cell> explored_way(const RunRecord& record, Size size);

/// The cells of a search run, by all of its steps and readings, including those of the reset. The speed run adds none.
/// @param record of a contest in steps.
/// @param maze the maze of the record.
ExploredCells explored_cells(const RunRecord& record, const Maze& maze);

/// The shares of the reachable cells that a search run discovered and visited.
/// @param cells at least one must be reachable.
/// @return each share 0 to 1.
Coverage coverage_of(const ExploredCells& cells);
/// The same for a record.
/// @param record of a contest in steps.
/// @param maze the maze of the record.
Coverage coverage_of(const RunRecord& record, const Maze& maze);
/// The same for given reachable cells.
/// @param record of a contest in steps.
/// @param size of the maze; cells outside of it are left out.
/// @param reachable at least one cell.
Coverage coverage_of(const RunRecord& record, Size size, const CellSet& reachable);

}  // namespace labmouse
