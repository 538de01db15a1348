#include "labmouse/lab/numbers/sign_flips.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include "labmouse/chance/rng.hpp"

namespace labmouse {
namespace {

/// The sum of the sizes with random or enumerated signs, one bit each.
template <class NextBits>
double flipped_sum(const std::vector<double>& sizes, NextBits next_bits) {
  double sum = 0.0;
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (i % 64 == 0) bits = next_bits();
    sum += (bits & 1U) != 0 ? sizes[i] : -sizes[i];
    bits >>= 1U;
  }
  return sum;
}

}  // namespace

double sign_flip_test(std::span<const double> differences, std::uint64_t seed) {
  constexpr std::size_t most_tried = 12;
  constexpr int samples = 9999;
  std::vector<double> sizes;
  double found = 0.0, all = 0.0;
  for (const double difference : differences) {
    if (is_equal(difference)) continue;
    sizes.push_back(std::abs(difference));
    found += difference;
    all += sizes.back();
  }
  if (sizes.empty()) return 1.0;
  const double limit = std::abs(found) - 1e-9 * all;  // sums in another order are rounded differently
  int as_far = 0;
  if (sizes.size() <= most_tried) {
    const std::uint64_t ways = std::uint64_t{1} << sizes.size();
    for (std::uint64_t way = 0; way < ways; ++way)
      if (std::abs(flipped_sum(sizes, [&] { return way; })) >= limit) ++as_far;
    return static_cast<double>(as_far) / static_cast<double>(ways);
  }
  Rng rng(seed);
  for (int i = 0; i < samples; ++i)
    if (std::abs(flipped_sum(sizes, [&] { return rng.bits(); })) >= limit) ++as_far;
  // The observed assignment counts as one of the samples.
  return (as_far + 1.0) / (samples + 1.0);
}

}  // namespace labmouse
