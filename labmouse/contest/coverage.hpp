// How much of a maze an exploration saw and walked: a function of its record.
#pragma once

#include <vector>

#include "labmouse/contest/record.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// Shares, 0 to 1, of the cells that can be reached from the start, at the end of the exploration.
struct Coverage {
  /// Visited cells, and those that a reading showed a way into: all cells of the corridors that were seen.
  double discovered = 0.0;
  /// Cells that the mouse stood in or drove through.
  double visited = 0.0;

  friend constexpr bool operator==(const Coverage&, const Coverage&) = default;
};

/// The cells that the exploration came into, in their order and as often as it did, the start first. Those that it
/// drove through are among them. Cells of a record that lie outside of a maze of that size are left out.
std::vector<Cell> explored_way(const RunRecord& record, Size size);

/// The shares of an exploration: of all of its steps, with the reading of the one that reset it.
Coverage coverage_of(const RunRecord& record, const Maze& maze);
/// The same, where the reachable cells (at least one) of the maze are known already.
Coverage coverage_of(const RunRecord& record, Size size, const CellSet& reachable);

}  // namespace labmouse
