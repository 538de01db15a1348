// Visits to cells as a heat map: counts on a scale of a few levels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "labmouse/maze/maze.hpp"

namespace labmouse::drawing {

/// How often the cells of a maze were visited; calls `visits` once for each cell.
class Heat {
 public:
  static constexpr int levels = 6;

  Heat(Size size, const std::function<int(Cell)>& visits) : size_(size) {
    if (!visits) return;
    for (int index = 0; index < size.area(); ++index) visits_.push_back(visits(size.cell_at(index)));
    peak_ = std::max(0, *std::max_element(visits_.begin(), visits_.end()));
  }

  /// The most visits of any cell.
  int peak() const { return peak_; }

  /// 0 for a cell never visited, else 1 to `levels`, linear from one visit to the peak.
  int level(Cell cell) const {
    const int visits = visits_.empty() ? 0 : visits_[static_cast<std::size_t>(size_.index(cell))];
    if (visits <= 1 || peak_ <= 1) return visits > 0 ? 1 : 0;
    return 1 + (visits - 1) * (levels - 1) / (peak_ - 1);
  }

 private:
  Size size_;
  std::vector<int> visits_;
  int peak_ = 0;
};

}  // namespace labmouse::drawing
