// Means, and tests and intervals of paired differences and ratios.
#pragma once

#include <cstdint>
#include <span>

#include "labmouse/lab/numbers/interval.hpp"

namespace labmouse {

/// The mean, summed in the order given; 0 for no values.
double mean(std::span<const double> values);

/// Two-sided exact sign test (Arbuthnott 1710): the p-value of that many differences below and above 0. 1 if both
/// counts are 0; they must not be negative.
double sign_test(int below, int above);

/// Statistics of the differences of two scores in the same mazes.
struct PairedDifference {
  int count = 0;
  double mean = 0.0;
  Interval interval;  ///< of the mean
  double p = 1.0;     ///< of the sign-flip test: two-sided
  int below = 0;
  int equal = 0;
  int above = 0;
  /// p-value of the sign test of `below` against `above`; equal ones are ignored.
  double sign_test = 1.0;
};

/// Differences below 1e-9 count as equal. Scores in steps are multiples of 1/30, so smaller differences are rounding
/// errors.
PairedDifference paired_difference(std::span<const double> differences, std::uint64_t seed);

/// The ratio of the means of two paired samples.
struct PairedRatio {
  double ratio = 0.0;
  Interval interval;
};

/// @param others Denominators, all above 0: as many as `values`, at least one.
PairedRatio paired_ratio(std::span<const double> values, std::span<const double> others, std::uint64_t seed);

}  // namespace labmouse
