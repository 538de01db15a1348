#include "labmouse/mouse/robot/yaw_ramp.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "labmouse/functions/angles.hpp"

namespace labmouse {
namespace {

/// A cube root by bisection; those of the standard libraries differ in their last bits.
double third_root(double cube) {
  double low = 0.0, high = std::max(1.0, cube);
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2.0;
    (middle * middle * middle > cube ? high : low) = middle;
  }
  return low;
}

/// The point after `distance` mm of a clothoid that starts straight and has turned by `angle` there: Fresnel's series.
PathPoint after_clothoid(double distance, double angle) {
  double ahead = 0.0;
  double aside = 0.0;
  double term = distance;
  for (int n = 0; n < 40; n += 2) {
    ahead += term / (2 * n + 1);
    term *= angle / (n + 1);
    aside += term / (2 * n + 3);
    term *= -angle / (n + 2);
  }
  return {ahead, aside, angle};
}

/// The angle after `distance` mm of a ramp with onsets. The curvature's slope rises evenly in the first, stays, and
/// falls evenly in the last.
double angle_on_ramp(const RampPath& ramp, double distance) {
  const double slope = ramp.peak / (ramp.length - ramp.onset);
  const auto onset_angle = [&](double driven) { return slope / ramp.onset * driven * driven * driven / 6.0; };
  if (distance <= ramp.onset) return onset_angle(distance);
  const double left = ramp.length - distance;
  if (left <= ramp.onset) return ramp.peak * (ramp.length / 2.0 - left) + onset_angle(left);
  const double within = distance - ramp.onset;
  return onset_angle(ramp.onset) + slope * (ramp.onset + within) * within / 2.0;
}

/// Moves a point along the ramp between two distances within which the angle is one polynomial: Gauss-Legendre
/// quadrature with eight points, exact to rounding for the angles of turns.
void integrate(const RampPath& ramp, double from, double to, PathPoint& point) {
  struct Sample {
    double place, weight;
  };
  constexpr std::array<Sample, 4> samples = {{{0.1834346424956498, 0.3626837833783620},
                                              {0.5255324099163290, 0.3137066458778873},
                                              {0.7966664774136267, 0.2223810344533745},
                                              {0.9602898564975363, 0.1012285362903763}}};
  const double middle = (from + to) / 2.0, reach = (to - from) / 2.0;
  for (const Sample& sample : samples)
    for (const double side : {-1.0, 1.0}) {
      const Direction direction = direction_of(angle_on_ramp(ramp, middle + side * sample.place * reach));
      point.ahead += sample.weight * reach * direction.cosine;
      point.aside += sample.weight * reach * direction.sine;
    }
}

}  // namespace

YawRamp ramp_to(double yaw_rate, const CurveLimits& limits) {
  if (limits.yaw_jerk <= 0.0) return {yaw_rate, yaw_rate / limits.yaw_acceleration, 0.0};
  const double onset = limits.yaw_acceleration / limits.yaw_jerk;
  if (yaw_rate >= limits.yaw_acceleration * onset) return {yaw_rate, yaw_rate / limits.yaw_acceleration + onset, onset};
  // Its largest yaw acceleration is not reached.
  const double half = std::sqrt(yaw_rate / limits.yaw_jerk);
  return {yaw_rate, 2.0 * half, half};
}

YawRamp ramp_of_half(double angle, const CurveLimits& limits) {
  const double jerk = limits.yaw_jerk, acceleration = limits.yaw_acceleration;
  if (jerk <= 0.0) return ramp_to(std::sqrt(angle * acceleration), limits);
  const double onset = acceleration / jerk;
  // rate * (rate / acceleration + onset) = angle
  const double rate = acceleration * (std::sqrt(onset * onset + 4.0 * angle / acceleration) - onset) / 2.0;
  if (rate >= acceleration * onset) return ramp_to(rate, limits);
  // 2 jerk * half³ = angle
  const double half = third_root(angle / (2.0 * jerk));
  return {jerk * half * half, 2.0 * half, half};
}

double RampPath::curvature_at(double distance) const {
  if (length <= 0.0) return peak;
  const double slope = peak / (length - onset);
  if (distance < onset) return slope * distance * distance / (2.0 * onset);
  const double left = length - distance;
  if (left < onset) return peak - slope * left * left / (2.0 * onset);
  return slope * (distance - onset / 2.0);
}

PathPoint RampPath::at(double distance) const {
  if (onset <= 0.0) return after_clothoid(distance, length > 0.0 ? peak * distance * distance / (2.0 * length) : 0.0);
  PathPoint point{0.0, 0.0, angle_on_ramp(*this, distance)};
  double from = 0.0;
  for (const double part_end : {onset, length - onset, length}) {
    const double to = std::min(distance, part_end);
    if (to > from) integrate(*this, from, to, point);
    from = std::max(from, to);
  }
  return point;
}

}  // namespace labmouse
