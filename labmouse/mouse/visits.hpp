// How often a mouse has visited each cell.
#pragma once

#include <cassert>
#include <cstdint>
#include <vector>

#include "labmouse/grid/cell.hpp"

namespace labmouse {

/// A count for each cell of a maze.
class Visits {
 public:
  explicit Visits(Size size) : size_(size), counts_(static_cast<std::size_t>(size.area()), 0) {}

  void add(Cell cell) { ++counts_[index(cell)]; }
  int of(Cell cell) const { return static_cast<int>(counts_[index(cell)]); }
  void clear() { counts_.assign(counts_.size(), 0); }

 private:
  std::size_t index(Cell cell) const {
    assert(size_.contains(cell));
    return static_cast<std::size_t>(size_.index(cell));
  }

  Size size_;
  std::vector<std::uint32_t> counts_;
};

}  // namespace labmouse
