// The random walk of the mice that wander through what they know.
#pragma once

#include <algorithm>

#include "labmouse/chance/dice.hpp"
#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/known_moves.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// At each step one of the cells that one move through passages can reach, all equally likely.
class RandomWalk {
 public:
  /// `stride` is the longest move in cells; the motion's own limit holds too.
  RandomWalk(const Briefing& briefing, int stride)
      : dice_(briefing.seed), stride_(std::min(stride, briefing.motion.longest)) {}

  Action step(const WallSet& passages, Pose pose) {
    const KnownMoves moves(passages, pose.cell, stride_);
    // Nowhere to go: look at the wall behind.
    if (moves.empty()) return Action::step(90, 0);
    const Move& move = moves[dice_.below(moves.count())];
    return move_in(pose.heading, move.direction, move.cells);
  }

 private:
  Dice dice_;
  int stride_;
};

inline constexpr Parameter random_walk_stride = {"stride",
                                                 ParameterType::whole,
                                                 "3",
                                                 1,
                                                 Motion::max_longest,
                                                 "",
                                                 "longest move, in cells, within the limit of the rules"};

}  // namespace labmouse
