#include "labmouse/lab/drawing/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace labmouse::drawing {
namespace {

/// A distance between ticks as digit × 10^exponent with the digit 1, 2 or 5.
struct RoundStep {
  int digit = 1;
  int exponent = 0;

  /// `count` steps as a number. For negative exponents it divides by a power of ten, which is exact, so 3 tenths give
  /// 0.3.
  double times(long count) const {
    double power = 1.0;
    for (int i = std::abs(exponent); i > 0; --i) power *= 10.0;
    const double digits = static_cast<double>(count * digit);
    return exponent < 0 ? digits / power : digits * power;
  }
};

/// The smallest round step of at least `least`, which is positive.
RoundStep round_step(double least) {
  RoundStep step;
  while (step.times(1) < least) ++step.exponent;
  while (step.times(1) >= least) --step.exponent;
  for (const int digit : {2, 5}) {
    step.digit = digit;
    if (step.times(1) >= least) return step;
  }
  return {1, step.exponent + 1};
}

}  // namespace

Axis::Axis(double low, double high, int begin, int end, int most_ticks, double least_step)
    : low_(low), high_(high), begin_(begin), end_(end) {
  const RoundStep step = round_step(std::max((high - low) / most_ticks, least_step));
  const auto last = std::lround(std::floor(high / step.times(1)));
  for (auto count = std::lround(std::ceil(low / step.times(1))); count <= last; ++count)
    ticks_.push_back(
        {place(step.times(count)), fmt::format("{:.{}f}", step.times(count), std::max(0, -step.exponent))});
}

Axis::Axis(const std::vector<std::string>& names, int begin, int end)
    : low_(-0.5), high_(static_cast<double>(names.size()) - 0.5), begin_(begin), end_(end) {
  for (std::size_t i = 0; i < names.size(); ++i) ticks_.push_back({place(static_cast<double>(i)), names[i]});
}

}  // namespace labmouse::drawing
