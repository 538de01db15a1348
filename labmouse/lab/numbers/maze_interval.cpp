#include "labmouse/lab/numbers/maze_interval.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "labmouse/chance/rng.hpp"
#include "labmouse/lab/numbers/student.hpp"
#include "labmouse/lab/numbers/wilson.hpp"

namespace labmouse {
namespace {

/// Sums over mazes that give a mean and its standard error. `centre` is subtracted from each value, to keep precision.
class Sums {
 public:
  explicit Sums(double centre) : centre_(centre) {}

  void add(const MazeSum& maze) {
    const double above = maze.sum - centre_ * maze.count;
    above_ += above;
    counts_ += maze.count;
    squares_ += above * above;
    products_ += above * maze.count;
    squared_counts_ += maze.count * maze.count;
    ++mazes_;
  }

  /// The mean, less the centre.
  double mean() const { return above_ / counts_; }

  /// Of the mean, by linearization (Cochran 1977, 6.4). A variance within rounding errors counts as 0.
  double standard_error() const {
    const double m = mean(), squares = squares_ - m * (2.0 * products_ - m * squared_counts_);
    if (squares <= 1e-12 * squares_) return 0.0;
    return std::sqrt(squares * mazes_ / (mazes_ - 1)) / counts_;
  }

 private:
  double centre_, above_ = 0.0, counts_ = 0.0, squares_ = 0.0, products_ = 0.0, squared_counts_ = 0.0;
  int mazes_ = 0;
};

/// How many standard errors the interval reaches down and up.
struct Reach {
  double down = 0.0;
  double up = 0.0;
};

/// Quantiles of (mean - centre) / standard error over resamples of the mazes, clamped to ±`most`. Resamples with a
/// standard error of 0 count as ±`most`, by the sign of their mean.
Reach bootstrap_reach(std::span<const MazeSum> mazes, double centre, double most, std::uint64_t seed) {
  constexpr std::size_t samples = 1999, tail = 50;  // 2.5 % on each side
  Rng rng(seed);
  const int count = static_cast<int>(mazes.size());
  std::vector<double> found(samples);
  for (double& t : found) {
    Sums sums(centre);
    for (int i = 0; i < count; ++i) sums.add(mazes[static_cast<std::size_t>(rng.below(count))]);
    const double error = sums.standard_error(), mean = sums.mean();
    t = error > 0.0 ? std::clamp(mean / error, -most, most) : mean > 0.0 ? most : mean < 0.0 ? -most : 0.0;
  }
  std::sort(found.begin(), found.end());
  return {found[samples - tail], -found[tail - 1]};
}

std::vector<MazeSum> with_values(std::span<const MazeSum> mazes) {
  std::vector<MazeSum> some;
  for (const MazeSum& maze : mazes)
    if (maze.count > 0.0) some.push_back(maze);
  return some;
}

}  // namespace

double mean_of(std::span<const MazeSum> mazes) {
  double sum = 0.0, count = 0.0;
  for (const MazeSum& maze : mazes) {
    sum += maze.sum;
    count += maze.count;
  }
  return count > 0.0 ? sum / count : 0.0;
}

Interval interval_of(std::span<const MazeSum> all, std::uint64_t seed) {
  const std::vector<MazeSum> mazes = with_values(all);
  const double middle = mean_of(mazes);
  if (mazes.size() < 2) return {middle, middle};
  Sums sums(middle);
  for (const MazeSum& maze : mazes) sums.add(maze);
  const double error = sums.standard_error(), t = student_quantile(static_cast<int>(mazes.size()) - 1);
  // Chosen by simulation (tests/lab/numbers/coverage_test.cpp). Resamples of fewer mazes often repeat one maze.
  // Resamples of tied values often have a standard error of 0, so the bootstrap needs a limit.
  constexpr std::size_t fewest_to_resample = 5;
  constexpr double most_of_t = 3.0, part_of_bootstrap = 0.75;
  Reach reach = {t, t};
  if (mazes.size() >= fewest_to_resample && error > 0.0) {
    const Reach bootstrap = bootstrap_reach(mazes, middle, most_of_t * t, seed);
    const auto farther = [&](double there) { return t + part_of_bootstrap * std::max(0.0, there - t); };
    reach = {farther(bootstrap.down), farther(bootstrap.up)};
  }
  return {middle - reach.down * error, middle + reach.up * error};
}

Interval mean_interval(std::span<const double> values, std::uint64_t seed) {
  std::vector<MazeSum> mazes;
  for (const double value : values) mazes.push_back({value, 1.0});
  return interval_of(mazes, seed);
}

Interval share_interval(std::span<const MazeSum> all) {
  const std::vector<MazeSum> mazes = with_values(all);
  double contests = 0.0;
  for (const MazeSum& maze : mazes) contests += maze.count;
  const double share = mean_of(mazes);
  if (mazes.size() < 2) return wilson_interval(share, contests);
  Sums sums(share);
  for (const MazeSum& maze : mazes) sums.add(maze);
  const double error = sums.standard_error(), independent = share * (1.0 - share) / contests;
  const double effect = independent > 0.0 ? std::max(1.0, error * error / independent) : 1.0;
  return wilson_interval(share, contests / effect, student_quantile(static_cast<int>(mazes.size()) - 1));
}

}  // namespace labmouse
