// 95 % intervals of means, ratios and shares over mazes. docs/explanation/statistics-and-bounds.md has the simulation
// that chose them.
#pragma once

#include <cstdint>
#include <span>

#include "labmouse/lab/numbers/interval.hpp"

namespace labmouse {

/// What one maze adds to a mean: the sum of its values, and how many there are. In a ratio of two figures, `sum` is of
/// the one above and `count` of the one below, which is above 0.
struct MazeSum {
  double sum = 0.0;
  double count = 0.0;
};

/// All sums over all counts; 0 of nothing.
double mean_of(std::span<const MazeSum> mazes);

/// The interval of that mean for mazes like these: the t interval, on each side three quarters of the way out to the
/// bootstrap-t interval (Efron 1982) where that reaches farther. The first is too narrow for skewed values, the second
/// for tied ones. Values of one maze are not independent, so mazes are what counts, and mazes without values do not. It
/// always contains the mean. Fewer than two mazes give the mean twice.
/// @param seed Seed of the 1,999 resamples: equal mazes in equal order give equal intervals.
Interval interval_of(std::span<const MazeSum> mazes, std::uint64_t seed);

/// The same where each maze has one value.
Interval mean_interval(std::span<const double> values, std::uint64_t seed);

/// The interval of a share (`sum` of `count` contests finished), within 0 to 1: that of wilson_interval with t
/// quantiles and with the effective number of contests (Korn and Graubard 1998), which is smaller where mazes differ. A
/// single maze has the interval of independent contests.
Interval share_interval(std::span<const MazeSum> mazes);

}  // namespace labmouse
