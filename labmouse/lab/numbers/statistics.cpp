#include "labmouse/lab/numbers/statistics.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

#include "labmouse/lab/numbers/maze_interval.hpp"
#include "labmouse/lab/numbers/sign_flips.hpp"

namespace labmouse {

double mean(std::span<const double> values) {
  if (values.empty()) return 0.0;
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

PairedRatio paired_ratio(std::span<const double> values, std::span<const double> others, std::uint64_t seed) {
  assert(values.size() == others.size() && !values.empty());
  std::vector<MazeSum> mazes;
  for (std::size_t i = 0; i < values.size(); ++i) mazes.push_back({values[i], others[i]});
  const double ratio = mean(values) / mean(others);
  return {ratio, including(interval_of(mazes, seed), ratio)};
}

double sign_test(int below, int above) {
  const int throws = below + above, middle = throws / 2, fewer = std::min(below, above);
  // Binomial coefficients up to the middle, divided by the middle one so that they never overflow. Each follows from
  // its neighbour towards the middle; those that underflow do not matter. The smallest are summed first.
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

PairedDifference paired_difference(std::span<const double> given, std::uint64_t seed) {
  PairedDifference found;
  std::vector<double> differences;
  for (const double difference : given) differences.push_back(is_equal(difference) ? 0.0 : difference);
  found.count = static_cast<int>(differences.size());
  found.mean = mean(differences);
  found.interval = mean_interval(differences, seed);
  found.p = sign_flip_test(differences, seed);
  for (const double difference : differences)
    ++(difference < 0.0 ? found.below : difference > 0.0 ? found.above : found.equal);
  found.sign_test = sign_test(found.below, found.above);
  return found;
}

}  // namespace labmouse
