// How the yaw rate of a turn rises from nothing, and the path meanwhile.
#pragma once

namespace labmouse {

/// A point of a path, in mm ahead and to the left of the path's first point, as seen in the direction there; and the
/// path's direction at the point, in rad to the left of that.
struct PathPoint {
  double ahead = 0.0;
  double aside = 0.0;
  double angle = 0.0;
};

/// The limits of a robot's curves. A ramp depends on the yaw acceleration and the yaw jerk alone.
struct CurveLimits {
  double lateral_acceleration = 0.0;  ///< mm/s²
  double yaw_acceleration = 0.0;      ///< rad/s²
  double yaw_speed = 0.0;             ///< rad/s; 0: no limit of its own
  double yaw_jerk = 0.0;              ///< rad/s³; 0: none
};

/// The rise to a yaw rate as fast as the limits allow: the yaw acceleration rises, stays, and falls.
struct YawRamp {
  double rate = 0.0;     ///< rad/s at its end
  double seconds = 0.0;  ///< of the whole
  double onset = 0.0;    ///< seconds of the first part, and of the last; 0 without a limit of yaw jerk
};

/// The ramp to a yaw rate.
/// @param yaw_rate rad/s, 0 or more.
/// @param limits the yaw acceleration must be greater than 0.
YawRamp ramp_to(double yaw_rate, const CurveLimits& limits);
/// The ramp that, followed by its mirror image, turns by an angle, without an arc between them.
/// @param angle rad of both together, greater than 0.
/// @param limits the yaw acceleration must be greater than 0.
YawRamp ramp_of_half(double angle, const CurveLimits& limits);

/// The path of a ramp: from a straight to the largest curvature.
struct RampPath {
  double length = 0.0;  ///< mm
  double onset = 0.0;   ///< mm at both of its ends in which the yaw acceleration changes; 0: a clothoid
  double peak = 0.0;    ///< the curvature at its end, rad/mm

  /// A point of the path.
  /// @param distance mm from its beginning, 0 to `length`.
  /// @return as seen from its beginning.
  PathPoint at(double distance) const;
  /// The curvature of the path at a point.
  /// @param distance mm from its beginning, 0 to `length`.
  /// @return rad/mm; `peak` for a ramp without length.
  double curvature_at(double distance) const;
};

}  // namespace labmouse
