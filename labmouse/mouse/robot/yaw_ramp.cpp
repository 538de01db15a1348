#include "labmouse/mouse/robot/yaw_ramp.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "labmouse/functions/angles.hpp"
#include "labmouse/mouse/robot/path_integral.hpp"

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

/// How the curvature rises along a ramp, whose yaw rate rises alike at one speed. All are symmetric: the mean curvature
/// is half of the peak.
struct Rise {
  /// The largest yaw acceleration and the largest yaw jerk of a rise by 1 rad/s in 1 s. Unused for trapezoids, where
  /// the limits give the duration of the yaw jerk.
  double acceleration = 0.0, jerk = 0.0;
  double (*angle)(const RampPath& ramp, double distance);      ///< rad
  double (*curvature)(const RampPath& ramp, double distance);  ///< rad/mm
  double (*growth)(const RampPath& ramp, double distance);     ///< of the curvature, rad/mm²
};

/// The curvature's slope rises evenly in the first onset, stays, and falls evenly in the last.
constexpr Rise trapezoid = {
    0.0, 0.0,
    [](const RampPath& ramp, double distance) {
      const double slope = ramp.peak / (ramp.length - ramp.onset);
      const auto onset_angle = [&](double driven) { return slope / ramp.onset * driven * driven * driven / 6.0; };
      if (distance <= ramp.onset) return onset_angle(distance);
      const double left = ramp.length - distance;
      if (left <= ramp.onset) return ramp.peak * (ramp.length / 2.0 - left) + onset_angle(left);
      const double within = distance - ramp.onset;
      return onset_angle(ramp.onset) + slope * (ramp.onset + within) * within / 2.0;
    },
    [](const RampPath& ramp, double distance) {
      const double slope = ramp.peak / (ramp.length - ramp.onset);
      if (distance < ramp.onset) return slope * distance * distance / (2.0 * ramp.onset);
      const double left = ramp.length - distance;
      if (left < ramp.onset) return ramp.peak - slope * left * left / (2.0 * ramp.onset);
      return slope * (distance - ramp.onset / 2.0);
    },
    [](const RampPath& ramp, double distance) {
      const double slope = ramp.peak / (ramp.length - ramp.onset), near = std::min(distance, ramp.length - distance);
      return near < ramp.onset ? slope * near / ramp.onset : slope;
    }};

/// (1 - cos(pi u)) / 2 of the peak at the share u of the way.
constexpr Rise sine = {pi / 2.0, pi / 2.0 * pi,
                       [](const RampPath& ramp, double distance) {
                         const double way = pi * distance / ramp.length;
                         return ramp.peak * ramp.length / (2.0 * pi) * (way - direction_of(way).sine);
                       },
                       [](const RampPath& ramp, double distance) {
                         return ramp.peak * (1.0 - direction_of(pi * distance / ramp.length).cosine) / 2.0;
                       },
                       [](const RampPath& ramp, double distance) {
                         return ramp.peak * pi / (2.0 * ramp.length) * direction_of(pi * distance / ramp.length).sine;
                       }};

/// 3 u² - 2 u³ of the peak at the share u of the way.
constexpr Rise cubic = {1.5, 6.0,
                        [](const RampPath& ramp, double distance) {
                          const double share = distance / ramp.length;
                          return ramp.peak * ramp.length * share * share * share * (1.0 - share / 2.0);
                        },
                        [](const RampPath& ramp, double distance) {
                          const double share = distance / ramp.length;
                          return ramp.peak * share * share * (3.0 - 2.0 * share);
                        },
                        [](const RampPath& ramp, double distance) {
                          const double share = distance / ramp.length;
                          return ramp.peak / ramp.length * 6.0 * share * (1.0 - share);
                        }};

const Rise& rise_of(TurnProfile profile) {
  constexpr static std::array rises = {trapezoid, sine, cubic, trapezoid};
  static_assert(rises.size() == turn_profile_names.size());
  return rises[static_cast<unsigned>(profile)];
}

bool is_trapezoid(TurnProfile profile) { return profile == TurnProfile::trapezoid || profile == TurnProfile::free; }

YawRamp trapezoid_to(double yaw_rate, const CurveLimits& limits) {
  if (limits.yaw_jerk <= 0.0) return {yaw_rate, yaw_rate / limits.yaw_acceleration, 0.0};
  const double onset = limits.yaw_acceleration / limits.yaw_jerk;
  if (yaw_rate >= limits.yaw_acceleration * onset) return {yaw_rate, yaw_rate / limits.yaw_acceleration + onset, onset};
  // Its largest yaw acceleration is not reached.
  const double half = std::sqrt(yaw_rate / limits.yaw_jerk);
  return {yaw_rate, 2.0 * half, half};
}

YawRamp trapezoid_of_half(double angle, const CurveLimits& limits) {
  const double jerk = limits.yaw_jerk, acceleration = limits.yaw_acceleration;
  if (jerk <= 0.0) return trapezoid_to(std::sqrt(angle * acceleration), limits);
  const double onset = acceleration / jerk;
  // rate * (rate / acceleration + onset) = angle
  const double rate = acceleration * (std::sqrt(onset * onset + 4.0 * angle / acceleration) - onset) / 2.0;
  if (rate >= acceleration * onset) return trapezoid_to(rate, limits);
  // 2 jerk * half³ = angle
  const double half = third_root(angle / (2.0 * jerk));
  return {jerk * half * half, 2.0 * half, half};
}

}  // namespace

YawRamp ramp_to(double yaw_rate, const CurveLimits& limits) {
  if (is_trapezoid(limits.profile)) return trapezoid_to(yaw_rate, limits);
  const Rise& rise = rise_of(limits.profile);
  double seconds = rise.acceleration * yaw_rate / limits.yaw_acceleration;
  if (limits.yaw_jerk > 0.0) seconds = std::max(seconds, std::sqrt(rise.jerk * yaw_rate / limits.yaw_jerk));
  return {yaw_rate, seconds, seconds / 2.0};
}

YawRamp ramp_of_half(double angle, const CurveLimits& limits) {
  if (is_trapezoid(limits.profile)) return trapezoid_of_half(angle, limits);
  const Rise& rise = rise_of(limits.profile);
  // rate * seconds = angle, with the time that the yaw acceleration needs, and with that of the yaw jerk
  double rate = std::sqrt(angle * limits.yaw_acceleration / rise.acceleration);
  if (limits.yaw_jerk > 0.0) rate = std::min(rate, third_root(angle * angle * limits.yaw_jerk / rise.jerk));
  return ramp_to(rate, limits);
}

double RampPath::curvature_at(double distance) const {
  return length <= 0.0 ? peak : rise_of(profile).curvature(*this, distance);
}

double RampPath::growth_at(double distance) const { return rise_of(profile).growth(*this, distance); }

PathPoint RampPath::at(double distance) const {
  if (onset <= 0.0) return after_clothoid(distance, length > 0.0 ? peak * distance * distance / (2.0 * length) : 0.0);
  PathPoint point{0.0, 0.0, rise_of(profile).angle(*this, distance)};
  double from = 0.0;
  for (const double part_end : {onset, length - onset, length}) {
    const double to = std::min(distance, part_end);
    if (to > from)
      move_along([&](double distance) { return rise_of(profile).angle(*this, distance); }, from, to, point);
    from = std::max(from, to);
  }
  return point;
}

}  // namespace labmouse
