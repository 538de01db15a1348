// Wilson's interval of a share.
#pragma once

#include <cstdint>

#include "labmouse/lab/numbers/interval.hpp"

namespace labmouse {

/// part / all; 0 if `all` is 0.
constexpr double share_of(std::int64_t part, std::int64_t all) {
  return all == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(all);
}

/// Wilson's score interval (1927) of a share of independent trials. It is valid for few trials, and where all or none
/// succeeded. Without trials it is 0 to 1. Contests in the same mazes are not independent: use share_interval for them.
/// @param deviations Half its width in standard deviations; the default gives 95 %.
Interval wilson_interval(double share, double trials, double deviations = 1.959963984540054);

}  // namespace labmouse
