#include "labmouse/strategies/ariadne/edge_costs.hpp"

#include <algorithm>

namespace labmouse::ariadne {

EdgeCosts::EdgeCosts(const Briefing& briefing)
    : size_(briefing.size),
      start_cell_(briefing.start.cell),
      goals_(briefing.goals),
      from_start_(briefing.size, briefing.motion, step_price),
      to_goal_(briefing.size, briefing.motion, step_price) {
  start_.insert(briefing.start.cell);
}

void EdgeCosts::plan(Outlook& outlook, int way_here) {
  const bool first = prices_ == nullptr;
  const bool first_from_start = first || way_here_ == 0;
  const WallSet changes = outlook.take_changes();
  prices_ = &outlook.prices();
  way_here_ = way_here;
  update(to_goal_, goals_, changes, first);
  if (way_here != 0) update(from_start_, start_, changes, first_from_start);
}

void EdgeCosts::update(PricedField& field, const CellSet& from, const WallSet& changes, bool first) {
  if (first)
    field.fill(*prices_, from);
  else
    field.refill(*prices_, from, changes);
}

int EdgeCosts::through(Wall wall) const {
  const bool north = wall.side == Heading::north;
  const std::uint8_t* prices = north ? prices_->north() : prices_->east();
  const int next = north ? size_.width : 1;  // from a cell to the one behind the wall
  int cheapest = unreachable;
  int first = size_.index(wall.cell);
  int price = prices[first];
  // All moves that begin `before` cells ahead of the wall; the border and walls taken for closed end them.
  for (int before = 0; before < to_goal_.longest(); ++before) {
    int last = size_.index(wall.cell) + next;
    int to_last = price;
    for (int cells = before + 1;; ++cells) {
      const int move = to_goal_.step_cost(cells) + to_last;
      const int there = way_to(first) + to_goal_.at_index(last), back = way_to(last) + to_goal_.at_index(first);
      cheapest = std::min(cheapest, move + std::min(there, back));
      if (cells == to_goal_.longest() || prices[last] == WallPrices::closed) break;
      to_last += prices[last];
      last += next;
    }
    first -= next;
    if (prices[first] == WallPrices::closed) break;
    price += prices[first];
  }
  return cheapest;
}

}  // namespace labmouse::ariadne
