// Computes the cost of the cheapest run from start to goal through a given unseen wall.
//
//   start ... s ==== wall ==== t ... goal        T(wall) = min over straight moves s -> t through it, both ways,
//        A(s)        a move       G(t)                     of  way_here * A(s) + the move's cost + G(t)
//
// A and G are cheapest costs over the prices of walls; a move costs its steps and the prices of the walls it crosses.
#pragma once

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/priced_field.hpp"
#include "labmouse/strategies/ariadne/policy.hpp"

namespace labmouse::ariadne {

class EdgeCosts {
 public:
  /// Allocates all memory. The briefing must outlive it.
  explicit EdgeCosts(const Briefing& briefing);

  /// Computes A and G. The prices must not change until the next plan. The weight of A is in 1/256; at 0, A is not
  /// computed.
  void plan(const WallPrices& prices, int way_here);
  /// The same, but only for cells t with G below a limit. T may be too large for walls that lead to other cells.
  void plan_near(int limit, const WallPrices& prices, int way_here);
  /// The same at weight 1, but only for walls with T below a limit. T of others may be too large.
  void plan_below(int limit, const WallPrices& prices);

  /// T of a wall that does not count as closed, in 1/30 step; `unreachable` or more if no run leads through.
  int through(Wall wall) const;

 private:
  int way_to(int cell) const;
  CellSet start() const { return CellSet::of(briefing_.start.cell); }

  const Briefing& briefing_;
  const WallPrices* prices_ = nullptr;
  int way_here_ = 0;
  PricedField from_start_;
  PricedField to_goal_;
};

}  // namespace labmouse::ariadne
