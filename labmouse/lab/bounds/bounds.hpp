// How low could anyone score here?
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "labmouse/contest/rules.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/action.hpp"
#include "labmouse/mouse/strategy.hpp"

namespace labmouse {

/// The limits of a maze under rules; nothing where no goal can be reached.
struct Bound {
  /// Steps of the shortest speed run. At least 1: a step has to end in a goal, even where the start is one.
  std::optional<int> optimum;
  /// The score of a mouse that knows the maze: it explores by one shortest run and the reset, then runs it again.
  std::optional<double> score;
};

Bound bound_of(const Maze& maze, const Rules& rules);

/// The actions of one shortest run from the start to a goal (the first in the order of next_move); empty where there is
/// none.
std::vector<Action> shortest_run(const Maze& maze, const Rules& rules);

/// The bound's witness: plays the shortest run, the reset, and the shortest run again. Not a contestant: it was made
/// from the maze.
std::unique_ptr<Strategy> make_oracle(const Maze& maze, const Rules& rules);

}  // namespace labmouse
