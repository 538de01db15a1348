#include "labmouse/controller/ramps.hpp"

#include <algorithm>
#include <cmath>

namespace labmouse {

Ramps::Ramps(double length, double from, double to, const RampLimits& limits) {
  const auto [top, up, down] = limits;
  const double reached = std::sqrt(std::max(0.0, from * from + 2.0 * up * length));
  const double least = std::sqrt(std::max(0.0, from * from - 2.0 * down * length));
  const double end = std::clamp(to, least, reached);
  const double peak_squared = (2.0 * up * down * length + down * from * from + up * end * end) / (up + down);
  const double peak = std::max({std::min(top, std::sqrt(peak_squared)), from, end});
  const double ramps = (peak * peak - from * from) / (2.0 * up) + (peak * peak - end * end) / (2.0 * down);
  const double even = peak > 0.0 ? std::max(0.0, length - ramps) / peak : 0.0;
  phases_ = {{{(peak - from) / up, from, up}, {even, peak, 0.0}, {(peak - end) / down, peak, -down}}};
}

Ramps::Ramps(double length, double speed) : phases_{{{length / speed, speed, 0.0}, {}, {}}} {
  phases_[1].speed = phases_[2].speed = speed;
}

double Ramps::seconds() const { return phases_[0].seconds + phases_[1].seconds + phases_[2].seconds; }

double Ramps::length_at(double seconds) const {
  double driven = 0.0;
  for (const Phase& phase : phases_) {
    const double spent = std::min(seconds, phase.seconds);
    driven += (phase.speed + phase.acceleration * spent / 2.0) * spent;
    seconds -= spent;
  }
  return driven;
}

double Ramps::speed_at(double seconds) const {
  for (const Phase& phase : phases_) {
    if (seconds <= phase.seconds) return phase.speed + phase.acceleration * seconds;
    seconds -= phase.seconds;
  }
  return phases_[2].speed + phases_[2].acceleration * phases_[2].seconds;
}

}  // namespace labmouse
