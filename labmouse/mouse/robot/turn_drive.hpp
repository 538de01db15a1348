// Turns at changing speed: the tyres' grip that the curve leaves is used to accelerate or to brake (a friction circle).
#pragma once

#include <array>
#include <optional>

#include "labmouse/mouse/robot/robot.hpp"
#include "labmouse/mouse/robot/turn_shape.hpp"

namespace labmouse {

/// Speeds along the curve of a turn, without its leads. Their squares are linear in each of equally long steps, so that
/// the acceleration is constant within a step.
struct TurnDrive {
  static constexpr int steps = 128;

  std::array<double, steps + 1> speeds{};  ///< mm/s, where the steps begin and end
  double seconds = 0.0;                    ///< of the whole curve
};

/// The fastest drive that the robot's limits allow, from one speed (mm/s) at the beginning of the curve to another at
/// its end, never above `top`, for which the path is laid out; nothing if there is none. For robots with grip and
/// without a limit of yaw jerk.
std::optional<TurnDrive> turn_drive(const TurnShape& shape, double from, double to, double top, const Robot& robot);

/// The largest speed, up to `top` mm/s, at which a path can both begin and end within the limits along it.
double end_speed_of(const TurnShape& shape, double top, const Robot& robot);

}  // namespace labmouse
