// Distance fields the plain way: what the rows of bits are tested and measured against.
#pragma once

#include <vector>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/motion.hpp"

namespace labmouse {

/// Costs as DistanceField gives them, by size.index(cell), with a queue of the standard library; written for clarity.
/// Any motion: the queue is one of (cost, cell) pairs in order (Dijkstra 1959).
std::vector<int> plain_distances(Size size, const Motion& motion, const WallSet& passages, const CellSet& from);

/// Breadth-first search for moves of cost one, the honest fast way with one cell at a time: passages in a flat array
/// read beforehand, a ring in an array for a queue, no memory taken while it runs.
class RingSearch {
 public:
  RingSearch(Size size, int longest, const WallSet& passages);

  const std::vector<int>& fill(const CellSet& from);

 private:
  Size size_;
  int longest_;
  std::vector<unsigned char> open_;  ///< four bits a cell, one a heading
  std::vector<int> distances_;
  std::vector<int> queue_;
};

}  // namespace labmouse
