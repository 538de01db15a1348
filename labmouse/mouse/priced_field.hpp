// Cheapest costs over walls that have prices.
//
// Method: Dijkstra with a ring of buckets (Dial 1969): one bucket for each cost that may still come, each a list of
// cells that are linked by their indices; a row of bits says which buckets hold anything.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "labmouse/grid/cell_set.hpp"
#include "labmouse/mouse/distance.hpp"
#include "labmouse/mouse/motion.hpp"
#include "labmouse/mouse/wall_prices.hpp"

namespace labmouse {

/// Cheapest costs from a set of cells: a straight move of k cells costs what the motion says, times a step's price, and
/// the prices of the walls that it leads through. Moves cost the same both ways, so these are the costs to the set, too.
class PricedField {
 public:
  /// Takes all memory that it will need: 4 KiB and 8 bytes a cell for strides at a step's price of 30.
  PricedField(Size size, const Motion& motion, int step_price);

  void fill(const WallPrices& prices, const CellSet& from);
  /// The same for those cells alone whose cost is below a limit; others may be unreachable. It ends the sooner.
  void fill_below(int limit, const WallPrices& prices, const CellSet& from);
  /// The same for those cells alone whose cost and their rest, a field over the same prices, add up to less than a limit.
  void fill_below(int limit, const PricedField& rest, const WallPrices& prices, const CellSet& from);

  /// The cost of a cell inside, or unreachable.
  int at(Cell cell) const { return at_index(size_.index(cell)); }
  /// The same by the cell's index.
  int at_index(int index) const { return costs_[static_cast<std::size_t>(index)]; }
  /// The price of a straight move of so many cells through open walls.
  int step_cost(int cells) const { return step_cost_[static_cast<unsigned>(cells)]; }
  int longest() const { return longest_; }

 private:
  using Index = std::uint16_t;
  /// The neighbours in a bucket's list.
  struct Link {
    Index before, next;
  };

  template <class Within>
  void search(const WallPrices& prices, const CellSet& from, Within within);
  template <class Within>
  void spread(const std::uint8_t* wall, int cell, int to_next, Within within);
  void reach(int cell, int cost);
  void leave_bucket(int cell);
  int take_first();
  bool next_bucket();

  Size size_;
  int longest_;
  std::array<int, Motion::max_longest + 1> step_cost_{};
  int mask_;     ///< buckets in the ring, less one
  int now_ = 0;  ///< cost of the cells that are settled now
  std::vector<std::int32_t> costs_;
  std::vector<Link> links_;         ///< of each cell that waits in a bucket
  std::vector<Index> first_;        ///< cell of each bucket
  std::vector<std::uint64_t> used_; ///< which buckets hold cells
};

}  // namespace labmouse
