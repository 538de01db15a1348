// A share and its interval.
#pragma once

#include <cstdint>

#include "labmouse/lab/numbers/interval.hpp"

namespace labmouse {

/// 0 of nothing.
constexpr double share_of(std::int64_t part, std::int64_t all) {
  return all == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(all);
}

/// Interval of a share of independent trials by its score (Wilson 1927): sound for few trials, and where all or none
/// succeeded. From 0 to 1 without any trial. Contests that share mazes are not independent: share_interval is for them.
/// @param deviations Half its width in standard deviations; as given, 95 %.
Interval wilson_interval(double share, double trials, double deviations = 1.959963984540054);

}  // namespace labmouse
