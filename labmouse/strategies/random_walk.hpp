// Random walk over known moves, for random and random-then-shortest.
#pragma once

#include <span>
#include <vector>

#include "labmouse/chance/rng.hpp"
#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/manhattan.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// Draws at each step one of the cells that one known move leads to, with equal probability.
class RandomWalk {
 public:
  /// `stride` is the longest move in cells.
  RandomWalk(const Briefing& briefing, int stride) : rng_(briefing.seed), stride_(stride) {
    near_.reserve(4 * static_cast<std::size_t>(Motion::max_longest));
  }

  /// Draws one of the connected cells within the stride; returns `here` if there is none.
  Cell next(Cell here, std::span<const Cell> connected) {
    near_.clear();
    for (const Cell cell : connected)
      if (manhattan(cell, here) <= stride_) near_.push_back(cell);
    return near_.empty() ? here : near_[static_cast<std::size_t>(rng_.below(static_cast<int>(near_.size())))];
  }

 private:
  Rng rng_;
  int stride_;
  std::vector<Cell> near_;
};

inline constexpr Parameter random_walk_stride =
    Parameter::whole("stride", "3", 1, Motion::max_longest, "Longest move, in cells; the rules may set a lower limit.");

}  // namespace labmouse
