// Where a contest in steps loses its score: the steps beyond the best possible ones, by the cell in which they began.
//
// A step that brings the mouse as near to the goal as a step can loses nothing. Any other loses what it falls behind:
//
//     lost(step) = 1 + d(after) - d(before)
//
// where d is the number of steps to the goal in the whole maze, which no mouse knows. Over a run that ends in a goal
// these add up to its steps beyond those of the shortest run. In the search run d is 0 from the first step that ends
// in a goal: whoever goes on then loses each step but the reset, as a mouse that knows the maze would go back at once.
// So over a finished contest
//
//     the sum of lost in the speed run + the sum of lost in the search run / search_factor = score - bound
//
// with the bound of bounds.hpp. Looking costs: what a search run loses was not always spent badly, for without it the
// speed run could be longer.
#pragma once

#include <optional>
#include <vector>

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// Lost steps by cell, as size.index(cell) counts them. They are never negative.
struct LostSteps {
  std::vector<int> search_run;
  std::vector<int> speed;

  friend bool operator==(const LostSteps&, const LostSteps&) = default;
};

/// Knows how far each cell of a maze is from the goal.
class LossMeter {
 public:
  LossMeter(const Maze& maze, const Rules& rules);

  /// What each step of that contest in this maze lost, also where it was not finished. Where no goal can be reached,
  /// nothing is lost.
  std::vector<int> by_step(const RunRecord& record) const;

  /// Where that contest in this maze lost its steps; nothing where it was not finished and so has no score.
  std::optional<LostSteps> lost(const RunRecord& record) const;

 private:
  Size size_;
  std::vector<bool> goal_;
  std::vector<int> distances_;
  /// Steps of the shortest run: those of the start, but at least 1.
  int optimum_ = 0;
};

}  // namespace labmouse
