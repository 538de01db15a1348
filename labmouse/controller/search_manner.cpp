#include "labmouse/controller/search_manner.hpp"

#include <algorithm>

#include "labmouse/functions/angles.hpp"
#include "labmouse/mouse/robot/fitted_turn.hpp"
#include "labmouse/mouse/robot/search_drive.hpp"

namespace labmouse {

SearchManner search_manner(const DriveModel& model, double speed) {
  const Robot& robot = model.robot;
  SearchManner manner;
  const double own = robot.search_speed > 0.0 ? robot.search_speed : robot.cell / (model.search.cell / 1e6);
  manner.speed = speed > 0.0 ? speed : own;
  manner.turn_speed = speed <= 0.0 && robot.search_turn_speed > 0.0 ? robot.search_turn_speed : manner.speed;
  manner.turn = robot.search_turn_speed > 0.0 ? turn_laid_out_for(robot.search_turn_speed, Turn::s90, robot).shape
                                              : search_turn(robot, model.tables.turns, model.shapes).shape;
  manner.acceleration = std::min(robot.acceleration, robot.braking);
  manner.known_speed = robot.known_speed;
  manner.known_acceleration = robot.known_acceleration > 0.0 ? robot.known_acceleration : manner.acceleration;
  if (robot.pivot_speed > 0.0) {
    manner.pivot = {robot.pivot_speed, robot.pivot_acceleration, robot.pivot_acceleration};
  } else {
    // A quarter turn takes that time: half of it accelerating, half braking.
    const double seconds = model.search.quarter / 1e6, rate = 4.0 * (pi / 2.0) / (seconds * seconds);
    manner.pivot = {rate * seconds, rate, rate};
  }
  return manner;
}

}  // namespace labmouse
