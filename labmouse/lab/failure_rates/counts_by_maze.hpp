// Counts of what went wrong over all mazes and in each, for the intervals of shares.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "labmouse/lab/failure_rates/failure_rates.hpp"
#include "labmouse/lab/numbers/maze_interval.hpp"

namespace labmouse {

/// A share as two counts: the part and the whole.
struct Share {
  std::int64_t part = 0;
  std::int64_t all = 0;
};

/// Counts over all mazes, with those of each maze.
class CountsByMaze {
 public:
  /// `mazes` may be empty: then contests count as independent.
  CountsByMaze(const FailureCounts& counts, std::vector<FailureCounts> mazes) : all(counts), mazes_(std::move(mazes)) {}

  /// The confidence interval of the share that `share` computes from counts.
  template <class ShareOf>
  Interval interval(ShareOf share) const {
    std::vector<MazeSum> sums;
    const auto add = [&](const FailureCounts& counts) {
      const Share of = share(counts);
      sums.push_back({static_cast<double>(of.part), static_cast<double>(of.all)});
    };
    for (const FailureCounts& maze : mazes_) add(maze);
    if (mazes_.empty()) add(all);
    return share_interval(sums);
  }

  FailureCounts all;

 private:
  std::vector<FailureCounts> mazes_;
};

/// The counts that `of` takes from tally number `place`: over all mazes, and in each.
template <class Of>
CountsByMaze counts_of(const MeasuredRates& measured, std::size_t place, Of of) {
  std::vector<FailureCounts> mazes;
  if (place < measured.by_maze.size())
    for (const FailureTally& tally : measured.by_maze[place]) mazes.push_back(of(tally));
  return {of(measured.tallies[place]), std::move(mazes)};
}

/// The counts of a class of brightness.
inline CountsByMaze of_brightness(const MeasuredRates& measured, std::size_t place, std::size_t bright) {
  return counts_of(measured, place, [&](const FailureTally& tally) { return tally.by_brightness[bright]; });
}

}  // namespace labmouse
