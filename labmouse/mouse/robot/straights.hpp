// The times of straights: a mouse speeds up as hard as allowed, stays at the limit, and brakes as late as possible.
#pragma once

#include <optional>

#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// The limits of straights of one kind: mm/s, mm/s².
struct StraightLimits {
  double speed = 0.0;
  double acceleration = 0.0;
  double braking = 0.0;
};

inline StraightLimits limits_along(const Robot& robot) { return {robot.speed, robot.acceleration, robot.braking}; }
inline StraightLimits limits_diagonal(const Robot& robot) {
  return {robot.speed_diagonal, robot.acceleration_diagonal, robot.braking_diagonal};
}

/// Seconds over `length` mm from one speed to another, neither above the limit; nothing where that cannot be done.
std::optional<double> seconds_between(double length, double from, double to, const StraightLimits& limits);

/// Seconds over `length` mm from a speed, accelerating all the way.
double seconds_onward(double length, double from, const StraightLimits& limits);

/// Seconds as whole microseconds, to the nearest.
DriveTime microseconds(double seconds);

/// Fills `straights.between` for its lanes; a unit is `unit` mm long. If a lane without a lead leads to itself, two
/// straights never last less than one of both their lengths: rounding is taken back.
void fill_between(StraightTimes& straights, double unit, const StraightLimits& limits);

/// The largest speed in the goal, in mm/s, from which a robot stops within `room` cells.
double end_speed(const Robot& robot, int room);

/// Fills start, finish and whole of tables whose lanes are set. A run starts at rest, `robot.run_up` behind the middle
/// of its cell, and ends in the middle of the goal as `robot.stop` says.
void fill_ends(DriveTables& tables, const Robot& robot);

}  // namespace labmouse
