// What a run from start to goal would cost that led through an unseen wall.
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
  /// Takes all memory that it will need. The briefing must live as long.
  explicit EdgeCosts(const Briefing& briefing);

  /// Finds A and G over prices that stay as they are until the next plan. The weight of A is in 1/256; at 0 there is no
  /// need for it.
  void plan(const WallPrices& prices, int way_here);
  /// The same for those cells t alone whose G is below a limit; the T of a wall may be too large where it leads to
  /// others.
  void plan_near(int limit, const WallPrices& prices, int way_here);
  /// The same at weight 1, for those walls alone whose T is below a limit; the T of others may be too large.
  void plan_below(int limit, const WallPrices& prices);

  /// T of a wall that is not taken for closed, in thirtieths of a step; unreachable or more where no run leads through.
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
