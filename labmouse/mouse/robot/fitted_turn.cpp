#include "labmouse/mouse/robot/fitted_turn.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/mouse/robot/turn_room.hpp"

namespace labmouse {
namespace {

CurveLimits curve_limits(const Robot& robot) { return {robot.lateral_acceleration, robot.yaw_acceleration}; }

/// The speed limit of the straights that the turn lies between.
double top_speed(Turn turn, const Robot& robot) {
  if (begins_diagonal(turn) && ends_diagonal(turn)) return robot.speed_diagonal;
  return ends_diagonal(turn) ? std::min(robot.speed, robot.speed_diagonal) : robot.speed;
}

std::string name_with_fit(Turn turn, const Robot& robot) {
  return "its turn " + std::string(name_of(turn)) + " does not fit into cells of " + millimetres(robot.cell);
}

std::string refusal_of_clearance(Turn turn, const Robot& robot, double best, double speed) {
  return name_with_fit(turn, robot) + " with a clearance of " + millimetres(robot.clearance) + ": at " +
         millimetres(speed) + "/s, its best, it comes within " + millimetres(best) + " of a post or a wall";
}

/// At which speed the curve of a half turn is as wide as a cell: wider the faster.
double speed_around_post(const Robot& robot) {
  const auto too_wide = [&](double speed) {
    return width_of(shape_at(Turn::f180, speed, curve_limits(robot), robot.cell)) > robot.cell;
  };
  double high = 1.0;
  while (!too_wide(high)) high *= 2.0;
  double low = 0.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2.0;
    (too_wide(middle) ? high : low) = middle;
  }
  return high;
}

/// Half a cell, as around the post in the middle; less where the curve would come too near to the wall ahead.
void shorten_leads(TurnShape& shape, const Robot& robot) {
  const double reach = shape.at(shape.lead_in + shape.length / 2.0).ahead - shape.lead_in;
  const double room = 1.5 * robot.cell - robot.clearance - reach;
  if (room < shape.lead_in) shape.lead_in = shape.lead_out = std::max(0.0, std::floor(room));
}

FittedTurn fitted_around_post(const Robot& robot) {
  FittedTurn fitted;
  const double speed = speed_around_post(robot);
  fitted.shape = shape_at(Turn::f180, speed, curve_limits(robot), robot.cell);
  shorten_leads(fitted.shape, robot);
  fitted.shape.clearance = clearance_of(fitted.shape, robot.cell);
  fitted.speed = std::min(speed, top_speed(Turn::f180, robot));
  if (fitted.shape.clearance < robot.clearance)
    fitted.error = refusal_of_clearance(Turn::f180, robot, fitted.shape.clearance, fitted.speed);
  return fitted;
}

}  // namespace

std::string millimetres(double length) {
  const long tenths = std::lround(length * 10.0);
  const std::string whole = std::to_string(tenths / 10);
  return (tenths % 10 == 0 ? whole : whole + "." + std::to_string(tenths % 10)) + " mm";
}

FittedTurn fitted_turn(Turn turn, const Robot& robot) {
  if (turn == Turn::f180) return fitted_around_post(robot);
  double best = -1.0;
  double best_speed = 0.0;
  for (int steps = static_cast<int>(top_speed(turn, robot) / speed_step); steps > 0; --steps) {
    const double speed = steps * speed_step;
    FittedTurn fitted{shape_at(turn, speed, curve_limits(robot), robot.cell), speed, {}};
    if (fitted.shape.lead_in < 0.0 || fitted.shape.lead_out < 0.0) continue;
    fitted.shape.clearance = clearance_of(fitted.shape, robot.cell);
    if (fitted.shape.clearance >= robot.clearance) return fitted;
    if (fitted.shape.clearance > best) best = fitted.shape.clearance, best_speed = speed;
  }
  if (best >= 0.0) return {{}, 0.0, refusal_of_clearance(turn, robot, best, best_speed)};
  return {{},
          0.0,
          name_with_fit(turn, robot) + ": even at " + millimetres(speed_step) +
              "/s its curve is too long; increase the yaw acceleration"};
}

}  // namespace labmouse
