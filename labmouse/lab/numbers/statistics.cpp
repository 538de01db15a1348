#include "labmouse/lab/numbers/statistics.hpp"

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

double sign_test(int below, int above) {
  const int throws = below + above, middle = throws / 2, fewer = std::min(below, above);
  // Binomial coefficients up to the middle as shares of the one there, which overflow at no size: each is made from its
  // neighbour towards the middle, and one too small for a double is too small to matter. The smallest are summed first.
  std::vector<double> shares(static_cast<std::size_t>(middle) + 1, 1.0);
  for (int i = middle; i > 0; --i)
    shares[static_cast<std::size_t>(i) - 1] = shares[static_cast<std::size_t>(i)] * i / (throws - i + 1);
  double tail = 0.0, half = 0.0;
  for (int i = 0; i <= middle; ++i) {
    half += shares[static_cast<std::size_t>(i)];
    if (i == fewer) tail = half;
  }
  const double all = throws % 2 == 0 ? 2.0 * half - 1.0 : 2.0 * half;
  return std::min(1.0, 2.0 * tail / all);
}

PairedDifference paired_difference(std::span<const double> differences, std::uint64_t seed) {
  constexpr double rounding = 1e-9;
  PairedDifference found;
  found.count = static_cast<int>(differences.size());
  found.mean = mean(differences);
  found.interval = bootstrap_interval(differences, seed);
  for (const double difference : differences)
    ++(difference <= -rounding ? found.below : difference >= rounding ? found.above : found.equal);
  found.sign_test = sign_test(found.below, found.above);
  return found;
}

}  // namespace labmouse
