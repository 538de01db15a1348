// Simple implementations of distance fields, against which DistanceField is tested and measured.
#pragma once

#include <vector>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/motion.hpp"

namespace labmouse {

/// Computes the costs of a DistanceField by Dijkstra's algorithm (1959) with a std::priority_queue. The result is
/// indexed by size.index(cell). Written for clarity; supports any motion.
std::vector<int> plain_distances(Size size, const Motion& motion, const WallSet& passages, const CellSet& from);

/// Breadth-first search for moves of cost one, a fair competitor that handles one cell at a time. Passages are read
/// into a flat array beforehand, the queue is an array, and fill() allocates no memory.
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
