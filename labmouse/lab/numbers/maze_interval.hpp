// 95 % intervals of means, ratios and shares over mazes. docs/explanation/statistics-and-bounds.md reports the
// simulation by which the methods were chosen.
#pragma once

#include <cstdint>
#include <span>

#include "labmouse/lab/numbers/interval.hpp"

namespace labmouse {

/// What one maze adds to a mean: the sum of its values, and how many there are. For a ratio of two figures, `sum` is
/// the numerator and `count` the denominator, which is positive.
struct MazeSum {
  double sum = 0.0;
  double count = 0.0;
};

/// The total of `sum` divided by the total of `count`; 0 without values.
double mean_of(std::span<const MazeSum> mazes);

/// The interval of mean_of for mazes of the same kind. It is the t interval; with five or more mazes, on a side where
/// the bootstrap-t interval (Efron 1982) is wider, it is extended by three quarters of the difference. The t interval
/// is too narrow for skewed values, the bootstrap for tied ones. Values of one maze are not independent, so mazes are
/// the sampling units; mazes without values are ignored. It always contains the mean. With fewer than two mazes, both
/// limits are the mean.
/// @param seed Seed of the 1,999 resamples: equal mazes in equal order give equal intervals.
Interval interval_of(std::span<const MazeSum> mazes, std::uint64_t seed);

/// interval_of where each maze has one value.
Interval mean_interval(std::span<const double> values, std::uint64_t seed);

/// The interval of a share (`sum` of `count` contests finished), within 0 to 1. It is wilson_interval with t quantiles
/// and the effective number of contests (Korn and Graubard 1998), which is smaller where mazes differ. For a single
/// maze, contests are treated as independent.
Interval share_interval(std::span<const MazeSum> mazes);

}  // namespace labmouse
