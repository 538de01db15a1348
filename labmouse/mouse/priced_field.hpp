// Least costs of routes where unseen walls have prices.
//
// Method: Dijkstra with a ring of buckets for its queue (CellBuckets).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "labmouse/grid/cell_set.hpp"
#include "labmouse/mouse/cell_buckets.hpp"
#include "labmouse/mouse/distance.hpp"
#include "labmouse/mouse/motion.hpp"
#include "labmouse/mouse/wall_prices.hpp"

namespace labmouse {

/// Least costs from a set of cells. A straight move of k cells costs its cost in the motion, times a step's price, plus
/// the prices of the walls that it passes. Moves cost the same both ways, so these are the costs to the set, too.
class PricedField {
 public:
  /// Takes all memory that it will need: 4 bytes a cell, and for the queue 4 bytes a cell and 2 KiB (with strides() and
  /// a step's price of 30).
  PricedField(Size size, const Motion& motion, int step_price);
  /// A second field that shares the queue, to save memory: the two must not be filled at the same time.
  PricedField sibling() const { return *this; }

  void fill(const WallPrices& prices, const CellSet& from);
  /// The same only for cells whose cost is below a limit; others may stay unreachable. It is faster.
  void fill_below(int limit, const WallPrices& prices, const CellSet& from);
  /// The same only for cells whose cost, plus that in `rest` (a field over the same prices), is below a limit.
  void fill_below(int limit, const PricedField& rest, const WallPrices& prices, const CellSet& from);

  /// The cost of a cell inside, or unreachable.
  int at(Cell cell) const { return at_index(size_.index(cell)); }
  /// The same by the cell's index.
  int at_index(int index) const { return costs_[static_cast<std::size_t>(index)]; }
  /// The price of a straight move of `cells` cells through open walls.
  int step_cost(int cells) const { return step_cost_[static_cast<unsigned>(cells)]; }
  int longest() const { return longest_; }

 private:
  PricedField(const PricedField&) = default;

  template <class Within>
  void search(const WallPrices& prices, const CellSet& from, Within within);
  template <class Within>
  void spread(int price, const std::uint8_t* wall, int cell, int to_next, Within within);
  void reach(int cell, int cost);

  Size size_;
  int longest_;
  std::array<int, Motion::max_longest + 1> step_cost_{};
  std::vector<std::int32_t> costs_;
  std::shared_ptr<CellBuckets> queue_;
};

}  // namespace labmouse
