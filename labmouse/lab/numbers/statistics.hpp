// Means with their intervals, and what paired differences show.
#pragma once

#include <cstdint>
#include <span>

#include "labmouse/lab/numbers/interval.hpp"

namespace labmouse {

/// The mean, summed in the order given; 0 for no values.
double mean(std::span<const double> values);

/// Two-sided exact sign test (Arbuthnott 1710): the chance that so many fair throws fall at least as unevenly as these.
/// 1 for no throws. Counts must not be negative.
double sign_test(int below, int above);

/// What the differences of two scores in the same mazes show.
struct PairedDifference {
  int count = 0;
  double mean = 0.0;
  Interval interval;  ///< of the mean
  double p = 1.0;     ///< of the sign-flip test: two-sided
  int below = 0;
  int equal = 0;
  int above = 0;
  /// Of those below 0 against those above; equal ones say nothing.
  double sign_test = 1.0;
};

/// Differences closer to 0 than a billionth count as equal: sums of whole steps and thirtieths of steps are further
/// apart or the same, and differ by less only where they were rounded on different ways.
PairedDifference paired_difference(std::span<const double> differences, std::uint64_t seed);

/// The mean of some values over that of others, which belong to them in pairs.
struct PairedRatio {
  double ratio = 0.0;
  Interval interval;
};

/// As many values as others, at least one of each; the sum of any choice of the others must be above 0.
PairedRatio paired_ratio(std::span<const double> values, std::span<const double> others, std::uint64_t seed);

}  // namespace labmouse
