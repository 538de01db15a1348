// How a turn is driven where its speed may change on the way: the tyres give what they do not need for the curve to
// speed up or to brake (a friction circle).
#pragma once

#include <array>
#include <optional>

#include "labmouse/mouse/robot/robot.hpp"
#include "labmouse/mouse/robot/turn_shape.hpp"

namespace labmouse {

/// Speeds along the curve of a turn, without its leads: even in squares over equally long steps, so that within a step
/// the acceleration is the same.
struct TurnDrive {
  static constexpr int steps = 128;

  std::array<double, steps + 1> speeds{};  ///< mm/s, where the steps begin and end
  double seconds = 0.0;                    ///< of all of it
};

/// As fast as the robot's limits allow from one speed (mm/s) at the beginning of the curve to another at its end, never
/// above a third, for which the path is laid out; nothing where that cannot be done. For robots with grip and without
/// a limit of yaw jerk.
std::optional<TurnDrive> turn_drive(const TurnShape& shape, double from, double to, double top, const Robot& robot);

}  // namespace labmouse
