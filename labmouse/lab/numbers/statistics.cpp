#include "labmouse/lab/numbers/statistics.hpp"

#include <algorithm>
#include <cassert>

#include "labmouse/chance/dice.hpp"

namespace labmouse {

double mean(std::span<const double> values) {
  if (values.empty()) return 0.0;
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

namespace {

/// The interval of what `of` makes of a sample: `count` of so many values, as pick() names them one by one.
template <class Of>
Interval bootstrap(std::size_t count, std::uint64_t seed, Of of) {
  constexpr std::size_t samples = 2000;
  constexpr std::size_t tail = samples / 40;  // 2.5 % on each side
  Dice dice(seed);
  std::vector<double> found(samples);
  for (double& sample : found)
    sample = of([&] { return static_cast<std::size_t>(dice.below(static_cast<int>(count))); });
  std::sort(found.begin(), found.end());
  return {found[tail], found[samples - 1 - tail]};
}

}  // namespace

Interval bootstrap_interval(std::span<const double> values, std::uint64_t seed) {
  if (values.empty()) return {};
  return bootstrap(values.size(), seed, [&](auto pick) {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += values[pick()];
    return sum / static_cast<double>(values.size());
  });
}

PairedRatio paired_ratio(std::span<const double> values, std::span<const double> others, std::uint64_t seed) {
  assert(values.size() == others.size() && !values.empty());
  PairedRatio found;
  found.ratio = mean(values) / mean(others);
  found.interval = bootstrap(values.size(), seed, [&](auto pick) {
    double sum = 0.0, of_others = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::size_t pair = pick();
      sum += values[pair];
      of_others += others[pair];
    }
    return sum / of_others;
  });
  return found;
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
