#include "labmouse/strategies/ariadne/edge_costs.hpp"

#include <algorithm>

namespace labmouse::ariadne {

EdgeCosts::EdgeCosts(const Briefing& briefing)
    : briefing_(briefing), from_start_(briefing.size, briefing.motion, step_price), to_goal_(from_start_.sibling()) {}

void EdgeCosts::plan(const WallPrices& prices, int way_here) {
  prices_ = &prices;
  way_here_ = way_here;
  to_goal_.fill(prices, briefing_.goals);
  if (way_here != 0) from_start_.fill(prices, start());
}

void EdgeCosts::plan_near(int limit, const WallPrices& prices, int way_here) {
  prices_ = &prices;
  way_here_ = way_here;
  to_goal_.fill_below(limit, prices, briefing_.goals);
  if (way_here != 0) from_start_.fill(prices, start());
}

void EdgeCosts::plan_below(int limit, const WallPrices& prices) {
  prices_ = &prices;
  way_here_ = one;
  to_goal_.fill_below(limit, prices, briefing_.goals);
  from_start_.fill_below(limit, to_goal_, prices, start());
}

/// Weighted A of the cell with that index.
inline int EdgeCosts::way_to(int cell) const {
  if (way_here_ == 0) return 0;
  const int cost = from_start_.at_index(cell);
  return cost >= unreachable ? unreachable : static_cast<int>(static_cast<std::int64_t>(way_here_) * cost / one);
}

int EdgeCosts::through(Wall wall) const {
  const bool north = wall.side == Heading::north;
  const std::uint8_t* prices = north ? prices_->north() : prices_->east();
  const int next = north ? briefing_.size.width : 1;  // from a cell to the one behind the wall
  int cheapest = unreachable;
  int first = briefing_.size.index(wall.cell);
  int price = prices[first];
  // All moves that begin `before` cells before the wall. The border and walls that count as closed end them.
  for (int before = 0; before < to_goal_.longest(); ++before) {
    int last = briefing_.size.index(wall.cell) + next;
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
