#include "labmouse/mouse/priced_field.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

namespace labmouse {
namespace {

/// No cell, no bucket's list.
constexpr std::uint16_t none = 0xFFFF;

}  // namespace

PricedField::PricedField(Size size, const Motion& motion, int step_price) : size_(size), longest_(motion.longest) {
  for (int k = 1; k <= longest_; ++k)
    step_cost_[static_cast<unsigned>(k)] = motion.cost[static_cast<unsigned>(k)] * step_price;
  const int dearest = step_cost(longest_) + longest_ * WallPrices::highest;
  const auto buckets = std::max(64U, std::bit_ceil(static_cast<unsigned>(dearest) + 1));
  mask_ = static_cast<int>(buckets) - 1;
  const auto cells = static_cast<std::size_t>(size.area());
  costs_.assign(cells, unreachable);
  next_.assign(cells, none);
  before_.assign(cells, none);
  first_.assign(buckets, none);
  used_.assign(buckets / 64, 0);
}

void PricedField::fill(const WallPrices& prices, const CellSet& from) {
  std::fill(costs_.begin(), costs_.end(), unreachable);
  now_ = 0;
  from.for_each([&](Cell cell) { reach(size_.index(cell), 0); });
  settle(prices);
}

void PricedField::refill(const WallPrices& prices, const CellSet& from, const WallSet& changed) {
  const int valid = nearest(changed);
  if (valid == unreachable) return;
  // A cell is forgotten before anything is reached from one that is kept.
  for (auto& cost : costs_)
    if (cost > valid) cost = unreachable;
  from.for_each([&](Cell cell) { costs_[static_cast<std::size_t>(size_.index(cell))] = 0; });
  const auto kept = static_cast<int>(costs_.size());
  for (int cell = 0; cell < kept; ++cell) {
    now_ = costs_[static_cast<std::size_t>(cell)];
    if (now_ <= valid) spread(prices, cell);
  }
  now_ = valid;
  settle(prices);
}

/// The lowest cost of a cell from which a move leads through one of the walls: no route to a cell of at most that cost
/// gains or loses by them. Unreachable where no cell is reached from which one does.
int PricedField::nearest(const WallSet& changed) const {
  int lowest = unreachable;
  changed.for_each([&](Wall wall) {
    for (int along = 1 - longest_; along <= longest_; ++along)
      if (const Cell cell = neighbour(wall.cell, wall.side, along); size_.contains(cell)) lowest = std::min(lowest, at(cell));
  });
  return lowest;
}

/// Takes the cells out of the buckets, the cheapest first, and goes on from them.
void PricedField::settle(const WallPrices& prices) {
  while (next_bucket()) {
    const int cell = first_[static_cast<std::size_t>(now_ & mask_)];
    leave(cell);
    spread(prices, cell);
  }
}

void PricedField::spread(const WallPrices& prices, int cell) {
  spread(prices.north() + cell, 0, cell, size_.width);
  spread(prices.north() + cell, -size_.width, cell, -size_.width);
  spread(prices.east() + cell, 0, cell, 1);
  spread(prices.east() + cell, -1, cell, -1);
}

/// Goes straight from a settled cell, and lowers the costs of the cells that it comes to.
void PricedField::spread(const std::uint8_t* wall, int to_wall, int cell, int to_next) {
  wall += to_wall;
  int price = now_;
  for (int cells = 1; cells <= longest_ && *wall != WallPrices::closed; ++cells) {
    price += *wall;
    cell += to_next;
    wall += to_next;
    if (const int cost = price + step_cost_[static_cast<unsigned>(cells)]; cost < costs_[static_cast<std::size_t>(cell)])
      reach(cell, cost);
  }
}

/// Moves a cell into the bucket of a lower cost.
void PricedField::reach(int cell, int cost) {
  if (costs_[static_cast<std::size_t>(cell)] != unreachable) leave(cell);
  costs_[static_cast<std::size_t>(cell)] = cost;
  const auto bucket = static_cast<std::size_t>(cost & mask_);
  const Index second = first_[bucket];
  next_[static_cast<std::size_t>(cell)] = second;
  before_[static_cast<std::size_t>(cell)] = none;
  if (second != none) before_[second] = static_cast<Index>(cell);
  first_[bucket] = static_cast<Index>(cell);
  used_[bucket / 64] |= std::uint64_t{1} << bucket % 64;
}

/// Takes a cell out of its bucket.
void PricedField::leave(int cell) {
  const auto bucket = static_cast<std::size_t>(costs_[static_cast<std::size_t>(cell)] & mask_);
  const Index before = before_[static_cast<std::size_t>(cell)], next = next_[static_cast<std::size_t>(cell)];
  if (next != none) before_[next] = before;
  if (before != none) {
    next_[before] = next;
    return;
  }
  first_[bucket] = next;
  if (next == none) used_[bucket / 64] &= ~(std::uint64_t{1} << bucket % 64);
}

/// Goes on to the next bucket that holds a cell, at most once around the ring; false where there is none.
bool PricedField::next_bucket() {
  const int words = static_cast<int>(used_.size());
  const int begin = now_ & mask_;
  std::uint64_t word = used_[static_cast<std::size_t>(begin / 64)] & ~std::uint64_t{0} << begin % 64;
  for (int ahead = 0; ahead <= words; ++ahead) {
    const int at = begin / 64 + ahead;
    if (ahead > 0) word = used_[static_cast<std::size_t>(at & (words - 1))];
    if (word != 0) {
      now_ += at * 64 + std::countr_zero(word) - begin;
      return true;
    }
  }
  return false;
}

}  // namespace labmouse
