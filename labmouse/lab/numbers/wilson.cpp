#include "labmouse/lab/numbers/wilson.hpp"

#include <algorithm>
#include <cmath>

namespace labmouse {

Interval wilson_interval(double share, double trials, double deviations) {
  if (trials <= 0.0) return {0.0, 1.0};
  const double n = trials, squared = deviations * deviations;
  const double middle = (share + squared / (2.0 * n)) / (1.0 + squared / n);
  const double reach =
      deviations / (1.0 + squared / n) * std::sqrt(share * (1.0 - share) / n + squared / (4.0 * n * n));
  return including({std::max(0.0, middle - reach), std::min(1.0, middle + reach)}, share);
}

}  // namespace labmouse
