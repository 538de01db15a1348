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
  links_.assign(cells, {none, none});
  first_.assign(buckets, none);
  used_.assign(buckets / 64, 0);
}

/// Moves a cell into the bucket of a lower cost.
inline void PricedField::reach(int cell, int cost) {
  if (costs_[static_cast<std::size_t>(cell)] != unreachable) leave_bucket(cell);
  costs_[static_cast<std::size_t>(cell)] = cost;
  const auto bucket = static_cast<std::size_t>(cost & mask_);
  const Index second = first_[bucket];
  links_[static_cast<std::size_t>(cell)] = {none, second};
  if (second != none) links_[second].before = static_cast<Index>(cell);
  first_[bucket] = static_cast<Index>(cell);
  used_[bucket / 64] |= std::uint64_t{1} << bucket % 64;
}

inline void PricedField::leave_bucket(int cell) {
  const Link link = links_[static_cast<std::size_t>(cell)];
  if (link.next != none) links_[link.next].before = link.before;
  if (link.before != none) {
    links_[link.before].next = link.next;
    return;
  }
  const auto bucket = static_cast<std::size_t>(costs_[static_cast<std::size_t>(cell)] & mask_);
  first_[bucket] = link.next;
  if (link.next == none) used_[bucket / 64] &= ~(std::uint64_t{1} << bucket % 64);
}

/// Takes the first cell out of the bucket at hand, which has one.
inline int PricedField::take_first() {
  const auto bucket = static_cast<std::size_t>(now_ & mask_);
  const Index cell = first_[bucket], second = links_[cell].next;
  first_[bucket] = second;
  if (second != none)
    links_[second].before = none;
  else
    used_[bucket / 64] &= ~(std::uint64_t{1} << bucket % 64);
  return cell;
}

/// Goes on to the next bucket that holds a cell, at most once around the ring; false where there is none.
inline bool PricedField::next_bucket() {
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

/// Goes straight from a settled cell, and lowers the costs of the cells that it comes to.
template <class Within>
void PricedField::spread(const std::uint8_t* wall, int cell, int to_next, Within within) {
  int price = now_;
  for (int cells = 1; cells <= longest_ && *wall != WallPrices::closed; ++cells) {
    price += *wall;
    cell += to_next;
    wall += to_next;
    const int cost = price + step_cost_[static_cast<unsigned>(cells)];
    if (cost < at_index(cell) && within(cell, cost)) reach(cell, cost);
  }
}

/// Reaches the cells that lie within, at their costs: takes cells out of the buckets, the cheapest first, and goes on from
/// them. Leaving out a cell must not change the costs of those that lie within.
template <class Within>
void PricedField::search(const WallPrices& prices, const CellSet& from, Within within) {
  std::fill(costs_.begin(), costs_.end(), unreachable);
  now_ = 0;
  from.for_each([&](Cell cell) { reach(size_.index(cell), 0); });
  const int north = size_.width;
  while (next_bucket()) {
    const int cell = take_first();
    spread(prices.north() + cell, cell, north, within);
    spread(prices.north() + cell - north, cell, -north, within);
    spread(prices.east() + cell, cell, 1, within);
    spread(prices.east() + cell - 1, cell, -1, within);
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
