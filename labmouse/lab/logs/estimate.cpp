#include "labmouse/lab/logs/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace labmouse {

Estimate said_within(double value, double error, double most) {
  return error > 0.0 && error <= most ? Estimate{value, error} : Estimate{value, 0.0};
}

bool leaves_less(std::span<const double> one, std::span<const double> other) {
  constexpr double half = 0.5, share = 0.9, deviations = 2.5;
  const auto count = static_cast<double>(one.size());
  double left = 0.0, left_by_other = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    left += one[i];
    left_by_other += other[i];
    squares += (other[i] - one[i]) * (other[i] - one[i]);
  }
  const double gain = left_by_other - left;
  const double deviation = std::sqrt(std::max(0.0, squares - gain * gain / count) * count / (count - 1.0));
  return left < half * left_by_other || (left < share * left_by_other && gain > deviations * deviation);
}

}  // namespace labmouse
