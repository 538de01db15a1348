// A 95 % interval.
#pragma once

#include <algorithm>

namespace labmouse {

struct Interval {
  double low = 0.0;
  double high = 0.0;

  friend bool operator==(const Interval&, const Interval&) = default;
};

/// The interval, extended to contain the value: a mean summed in another order may lie outside by rounding.
inline Interval including(const Interval& interval, double value) {
  return {std::min(interval.low, value), std::max(interval.high, value)};
}

/// The interval of the value times a factor, which may be negative.
inline Interval scaled(const Interval& interval, double factor) {
  const double one = factor * interval.low, other = factor * interval.high;
  return {std::min(one, other), std::max(one, other)};
}

}  // namespace labmouse
