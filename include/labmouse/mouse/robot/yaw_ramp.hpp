// How the yaw rate of a turn rises from nothing, and the path meanwhile.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace labmouse {

/// How the yaw rate rises at the beginning of a turn; it falls in the same way. `trapezoid`: at a steady yaw
/// acceleration, which itself rises and falls steadily where yaw jerk is limited. `sine`: as half a cosine wave.
/// `cubic`: as the cubic polynomial that begins and ends without yaw acceleration. `free`: each turn has the fastest
/// path that was found, which may begin and end with a bend to the other side; every bend of it is a trapezoid.
enum class TurnProfile : std::uint8_t { trapezoid, sine, cubic, free };

/// The names of the profiles in robot files, in the order of the enumeration.
inline constexpr std::array<std::string_view, 4> turn_profile_names = {"trapezoid", "sine", "cubic", "free"};
/// The name of a profile in robot files.
/// @param profile one of the enumeration.
/// @return in static memory.
constexpr std::string_view name_of(TurnProfile profile) { return turn_profile_names[static_cast<unsigned>(profile)]; }

/// A point of a path, in mm ahead and to the left of the path's first point, as seen in the direction there; and the
/// path's direction at the point, in rad to the left of that.
struct PathPoint {
  double ahead = 0.0;
  double aside = 0.0;
  double angle = 0.0;
};

/// The limits of a robot's curves, and their profile. A ramp depends on the yaw acceleration, the yaw jerk and the
/// profile alone.
struct CurveLimits {
  double lateral_acceleration = 0.0;  ///< mm/s²
  double yaw_acceleration = 0.0;      ///< rad/s²
  double yaw_speed = 0.0;             ///< rad/s; 0: no limit of its own
  double yaw_jerk = 0.0;              ///< rad/s³; 0: none
  TurnProfile profile = TurnProfile::trapezoid;
};

/// The rise to a yaw rate as fast as the limits and the profile allow: the yaw acceleration rises, stays, and falls.
/// Its mean yaw rate is half of that at its end.
struct YawRamp {
  double rate = 0.0;     ///< rad/s at its end
  double seconds = 0.0;  ///< of the whole
  double onset = 0.0;    ///< seconds of the first part, and of the last; 0 of a trapezoid without a limit of yaw jerk
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
  TurnProfile profile = TurnProfile::trapezoid;

  /// A point of the path.
  /// @param distance mm from its beginning, 0 to `length`.
  /// @return as seen from its beginning.
  PathPoint at(double distance) const;
  /// The curvature of the path at a point.
  /// @param distance mm from its beginning, 0 to `length`.
  /// @return rad/mm; `peak` for a ramp without length.
  double curvature_at(double distance) const;
  /// How fast the curvature grows along the path at a point.
  /// @param distance mm from its beginning, 0 to `length`, which must be greater than 0.
  /// @return rad/mm², 0 or more.
  double growth_at(double distance) const;
};

}  // namespace labmouse
