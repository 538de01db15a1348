#include "labmouse/mouse/priced_field.hpp"

#include <algorithm>

namespace labmouse {

PricedField::PricedField(Size size, const Motion& motion, int step_price)
    : size_(size), longest_(motion.longest), costs_(static_cast<std::size_t>(size.area()), unreachable) {
  for (int k = 1; k <= longest_; ++k)
    step_cost_[static_cast<unsigned>(k)] = motion.cost[static_cast<unsigned>(k)] * step_price;
  queue_ = std::make_shared<CellBuckets>(size.area(), step_cost(longest_) + longest_ * WallPrices::highest);
}

/// Lowers the cost of a cell, or reaches it for the first time.
inline void PricedField::reach(int cell, int cost) {
  std::int32_t& known = costs_[static_cast<std::size_t>(cell)];
  if (known != unreachable) queue_->erase(cell, known);
  known = cost;
  queue_->insert(cell, cost);
}

/// Goes straight from a settled cell, and lowers the costs of the cells that it comes to.
template <class Within>
void PricedField::spread(int price, const std::uint8_t* wall, int cell, int to_next, Within within) {
  for (int cells = 1; cells <= longest_ && *wall != WallPrices::closed; ++cells) {
    price += *wall;
    cell += to_next;
    wall += to_next;
    const int cost = price + step_cost_[static_cast<unsigned>(cells)];
    if (cost < at_index(cell) && within(cell, cost)) reach(cell, cost);
  }
}

/// Dijkstra's search over the cells for which within(cell, cost) holds. Leaving out a cell must not change the costs of
/// these.
template <class Within>
void PricedField::search(const WallPrices& prices, const CellSet& from, Within within) {
  std::fill(costs_.begin(), costs_.end(), unreachable);
  from.for_each([&](Cell cell) { reach(size_.index(cell), 0); });
  const int north = size_.width;
  for (int cost = 0; queue_->find(cost);) {
    const int cell = queue_->take(cost);
    spread(cost, prices.north() + cell, cell, north, within);
    spread(cost, prices.north() + cell - north, cell, -north, within);
    spread(cost, prices.east() + cell, cell, 1, within);
    spread(cost, prices.east() + cell - 1, cell, -1, within);
  }
}

void PricedField::fill(const WallPrices& prices, const CellSet& from) {
  search(prices, from, [](int, int) { return true; });
}

void PricedField::fill_below(int limit, const WallPrices& prices, const CellSet& from) {
  search(prices, from, [limit](int, int cost) { return cost < limit; });
}

void PricedField::fill_below(int limit, const PricedField& rest, const WallPrices& prices, const CellSet& from) {
  search(prices, from, [limit, &rest](int cell, int cost) { return cost + rest.at_index(cell) < limit; });
}

}  // namespace labmouse
