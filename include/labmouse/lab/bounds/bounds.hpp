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

/// Lower bounds for a maze; empty where no goal can be reached.
struct Bound {
  /// Steps of the shortest speed run. At least 1: a run needs a step that ends in a goal, even where the start is a
  /// goal.
  std::optional<int> optimum;
  /// The score of a mouse that knows the maze: its search run is a shortest run and the reset, its speed run the same
  /// again.
  std::optional<double> score;
};

Bound bound_of(const Maze& maze, const Rules& rules);

/// The actions of one shortest run from the start to a goal; empty where there is none. Ties are broken by the order of
/// next_move.
std::vector<Action> shortest_run(const Maze& maze, const Rules& rules);

/// A strategy that scores the bound: it plays the shortest run, the reset, and the shortest run again. It does not
/// compete, because it knows the maze.
std::unique_ptr<Strategy> make_oracle(const Maze& maze, const Rules& rules);

}  // namespace labmouse
