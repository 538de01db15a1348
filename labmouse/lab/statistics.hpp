// Means with their intervals.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace labmouse {

/// A 95 % interval.
struct Interval {
  double low = 0.0;
  double high = 0.0;

  friend bool operator==(const Interval&, const Interval&) = default;
};

/// The mean, summed in the order given; 0 for no values.
double mean(std::span<const double> values);

/// 95 % percentile interval of the mean by 2,000 bootstrap samples (Efron 1979), seeded: equal values in equal order give
/// equal intervals. One value gives that value twice; none gives zeros.
Interval bootstrap_interval(std::span<const double> values, std::uint64_t seed);

}  // namespace labmouse
