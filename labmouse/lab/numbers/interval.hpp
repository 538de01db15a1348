// A 95 % interval.
#pragma once

#include <algorithm>

namespace labmouse {

struct Interval {
  double low = 0.0;
  double high = 0.0;

  friend bool operator==(const Interval&, const Interval&) = default;
};

/// Moved apart as far as it takes to contain the value: a mean that was summed in another order is rounded differently.
inline Interval including(const Interval& interval, double value) {
  return {std::min(interval.low, value), std::max(interval.high, value)};
}

/// That of the value times a factor, which may be below 0.
inline Interval scaled(const Interval& interval, double factor) {
  const double one = factor * interval.low, other = factor * interval.high;
  return {std::min(one, other), std::max(one, other)};
}

}  // namespace labmouse
