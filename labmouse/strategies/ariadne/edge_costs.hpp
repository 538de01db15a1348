// What a run from start to goal would cost that led through an unseen wall.
//
//   start ... s ==== wall ==== t ... goal        T(wall) = min over straight moves s -> t through it, both ways,
//        A(s)        a move       G(t)                     of  way_here * A(s) + the move's cost + G(t)
//
// A and G are cheapest costs over the prices of walls; a move costs its steps and the prices of the walls it crosses.
#pragma once

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/priced_field.hpp"
#include "labmouse/strategies/ariadne/outlook.hpp"
#include "labmouse/strategies/ariadne/policy.hpp"

namespace labmouse::ariadne {

class EdgeCosts {
 public:
  /// Takes all memory that it will need.
  explicit EdgeCosts(const Briefing& briefing);

  /// Finds A and G anew. The weight is of A, in 1/256; at 0 there is no need for it.
  void plan(Outlook& outlook, int way_here);

  /// T of a wall that is not taken for closed, in thirtieths of a step; unreachable or more where no run leads through.
  int through(Wall wall) const;
  /// The cheapest run that goes through walls at their prices.
  int best() const { return to_goal_.at(start_cell_); }

 private:
  void update(PricedField& field, const CellSet& from, const WallSet& changes, bool first);
  int way_to(int cell) const { return static_cast<int>(static_cast<std::int64_t>(way_here_) * from_start_.at_index(cell) / one); }

  Size size_;
  Cell start_cell_;
  CellSet start_;
  CellSet goals_;
  const WallPrices* prices_ = nullptr;
  int way_here_ = 0;
  PricedField from_start_;
  PricedField to_goal_;
};

}  // namespace labmouse::ariadne
