// A share and its interval.
#pragma once

#include <cstdint>

#include "labmouse/lab/numbers/statistics.hpp"

namespace labmouse {

/// 0 of nothing.
constexpr double share_of(std::int64_t part, std::int64_t all) {
  return all == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(all);
}

/// 95 % interval of a share by its score (Wilson 1927): sound for few trials, and where all or none succeeded. From 0
/// to 1 without any trial.
Interval wilson_interval(int successes, int trials);

}  // namespace labmouse
