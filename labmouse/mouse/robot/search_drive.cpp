#include "labmouse/mouse/robot/search_drive.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/mouse/robot/angles.hpp"
#include "labmouse/mouse/robot/fitted_turn.hpp"
#include "labmouse/mouse/robot/straights.hpp"

namespace labmouse {
namespace {

/// Seconds of a turn on the spot, from rest to rest.
double pivot_seconds(const Robot& robot, double angle) {
  return *seconds_between(angle, 0.0, 0.0, {robot.pivot_speed, robot.pivot_acceleration, robot.pivot_acceleration});
}

std::string refusal(const Robot& robot, double small_turn_speed) {
  const std::string it = "its search speed, " + millimetres(robot.search_speed) + "/s, ";
  if (robot.search_turn_speed <= 0.0 && robot.search_speed > small_turn_speed)
    return it + "is above that of its turn S90, " + millimetres(small_turn_speed) +
           "/s; lower it, or give the turns of a search a speed of their own, search.turn_speed";
  const double stopping = std::sqrt(robot.cell * std::min(robot.acceleration, robot.braking));
  if (robot.search_speed > stopping)
    return it + "cannot be reached or stopped from within half a cell; the limit is " +
           millimetres(std::floor(stopping)) + "/s";
  return "";
}

/// What braking to a lower speed and speeding up again costs, in seconds, on a way that is driven at the higher one.
double seconds_lost(double speed, double lower, const Robot& robot) {
  if (lower >= speed) return 0.0;
  const double less = speed - lower;
  return less * less / (2.0 * speed) * (1.0 / robot.braking + 1.0 / robot.acceleration);
}

}  // namespace

SearchModel search_model(const Robot& robot, const TurnShape& small_turn, double small_turn_speed) {
  if (robot.search.cell != 0) return {robot.search, {}};
  const double speed = robot.search_speed;
  if (!(speed > 0.0 && robot.pivot_speed > 0.0 && robot.pivot_acceleration > 0.0))
    return {{}, "its search speed, pivot speed and pivot acceleration must be greater than 0"};
  if (std::string why = refusal(robot, small_turn_speed); !why.empty()) return {{}, std::move(why)};
  const double slower = std::min(robot.acceleration, robot.braking);
  SearchDrive drive;
  drive.cell = microseconds(robot.cell / speed);
  drive.turn = microseconds(small_turn.whole() / speed);
  if (const double slow = robot.search_turn_speed; slow > 0.0) {
    const FittedTurn own = turn_laid_out_for(slow, Turn::s90, robot);
    if (!own.error.empty()) return {{}, own.error + "; change search.turn_speed"};
    drive.turn = microseconds(own.shape.whole() / slow + seconds_lost(speed, slow, robot));
  }
  drive.half_cell = microseconds(speed / slower + (robot.cell / 2.0 - speed * speed / (2.0 * slower)) / speed);
  drive.quarter = microseconds(pivot_seconds(robot, pi / 2.0));
  drive.back = 2 * drive.half_cell + microseconds(pivot_seconds(robot, pi));
  return {drive, {}};
}

}  // namespace labmouse
