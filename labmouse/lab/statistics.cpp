#include "labmouse/lab/statistics.hpp"

#include <algorithm>

#include "labmouse/chance/dice.hpp"

namespace labmouse {

double mean(std::span<const double> values) {
  if (values.empty()) return 0.0;
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

Interval bootstrap_interval(std::span<const double> values, std::uint64_t seed) {
  if (values.empty()) return {};
  constexpr std::size_t samples = 2000;
  constexpr std::size_t tail = samples / 40;  // 2.5 % on each side
  Dice dice(seed);
  std::vector<double> means(samples);
  for (double& sample : means) {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
      sum += values[static_cast<std::size_t>(dice.below(static_cast<int>(values.size())))];
    sample = sum / static_cast<double>(values.size());
  }
  std::sort(means.begin(), means.end());
  return {means[tail], means[samples - 1 - tail]};
}

}  // namespace labmouse
