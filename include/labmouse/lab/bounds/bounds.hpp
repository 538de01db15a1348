// Lower bounds of the score in the world of steps.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "labmouse/contest/rules.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/action.hpp"
#include "labmouse/mouse/strategy.hpp"

namespace labmouse {

/// Lower bounds for a maze; both are empty if no goal can be reached.
struct Bound {
  /// Steps of the shortest speed run, at least 1: a run needs a step that ends in a goal, even if the start is a goal.
  std::optional<int> optimum;
  /// The score of a mouse that knows the maze, in steps of the speed run: its search run is a shortest run and the
  /// reset, its speed run is the shortest run again.
  std::optional<double> score;
};

/// The best possible score of a maze, and the length of its shortest run.
/// @param maze the whole maze.
/// @param rules its stride and search factor count; its budget does not, so a bound may need more steps than that.
/// @return both numbers; empty if no goal can be reached.
Bound bound_of(const Maze& maze, const Rules& rules);

/// One shortest run from the start to a goal.
/// @param maze the whole maze.
/// @param rules only its stride counts, in cells.
/// @return one action for each step, always of the same one of several shortest runs; empty if no goal can be reached.
std::vector<Action> shortest_run(const Maze& maze, const Rules& rules);

/// A strategy that scores the bound: it plays the shortest run, the reset, and the shortest run again. It does not
/// compete, because it knows the maze.
/// @param maze the maze of the contest; it need not outlive the result.
/// @param rules only its stride counts, in cells.
/// @return never null; if no goal can be reached, the strategy only resets and then forfeits.
std::unique_ptr<Strategy> make_oracle(const Maze& maze, const Rules& rules);

}  // namespace labmouse
