// The fastest way to drive a turn within its cells.
#pragma once

#include <string>

#include "labmouse/mouse/robot/robot.hpp"
#include "labmouse/mouse/robot/turn_shape.hpp"

namespace labmouse {

/// The step of the speeds that are tried for a turn, mm/s.
inline constexpr double speed_step = 5.0;

struct FittedTurn {
  TurnShape shape;
  double speed = 0.0;  ///< mm/s
  std::string error;   ///< why no speed fits, in mm and mm/s
};

/// Fits a turn into its cells: both leads are 0 or more, and the path keeps the robot's clearance. It has the largest
/// such speed in steps of 5 mm/s, or the one that the robot gives. The width of a 180 leaves one curve only; its speed
/// is what the limits allow on it.
FittedTurn fitted_turn(Turn turn, const Robot& robot);

/// The turn on the path for a speed (mm/s), whatever the robot gives; not for a 180.
FittedTurn turn_laid_out_for(double speed, Turn turn, const Robot& robot);

/// The speed limit of the straights that a turn lies between, mm/s.
double turn_top_speed(Turn turn, const Robot& robot);

/// The limits of a robot's curves.
CurveLimits curve_limits(const Robot& robot);

/// "12.3", "12"
std::string to_tenths(double number);
/// "12.3 mm"
std::string millimetres(double length);

}  // namespace labmouse
