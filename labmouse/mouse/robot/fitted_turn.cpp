#include "labmouse/mouse/robot/fitted_turn.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/mouse/robot/turn_room.hpp"

namespace labmouse {
namespace {

std::string name_with_fit(Turn turn, const Robot& robot) {
  return "its turn " + std::string(name_of(turn)) + " does not fit into cells of " + millimetres(robot.cell);
}

std::string refusal_of_clearance(Turn turn, const Robot& robot, double best, double speed) {
  return name_with_fit(turn, robot) + " with a clearance of " + millimetres(robot.clearance) + ": at " +
         millimetres(speed) + "/s, its best, it comes within " + millimetres(best) + " of a post or a wall";
}

/// The speed at which the curve of a half turn is as wide as a cell; it widens with the speed.
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

/// Sets both leads of a 180: as given, or half a cell, so that the curve begins and ends beside the post that it goes
/// around. They are less if the curve would come too near to the wall ahead.
void set_leads_around_post(TurnShape& shape, const Robot& robot) {
  if (const double given = robot.layout(Turn::f180).given; given > 0.0) {
    shape.lead_in = shape.lead_out = given;
    return;
  }
  const double reach = shape.at(shape.lead_in + shape.length / 2.0).ahead - shape.lead_in;
  const double room = 1.5 * robot.cell - robot.clearance - reach;
  if (room < shape.lead_in) shape.lead_in = shape.lead_out = std::max(0.0, std::floor(room));
}

FittedTurn fitted_around_post(const Robot& robot) {
  FittedTurn fitted;
  const double speed = speed_around_post(robot);
  fitted.shape = shape_at(Turn::f180, speed, curve_limits(robot), robot.cell);
  set_leads_around_post(fitted.shape, robot);
  fitted.shape.clearance = clearance_of(fitted.shape, robot.cell);
  fitted.speed = std::min(speed, turn_top_speed(Turn::f180, robot));
  if (fitted.shape.clearance < robot.clearance)
    fitted.error = refusal_of_clearance(Turn::f180, robot, fitted.shape.clearance, fitted.speed);
  return fitted;
}

}  // namespace

double turn_top_speed(Turn turn, const Robot& robot) {
  if (begins_diagonal(turn) && ends_diagonal(turn)) return robot.speed_diagonal;
  return ends_diagonal(turn) ? std::min(robot.speed, robot.speed_diagonal) : robot.speed;
}

CurveLimits curve_limits(const Robot& robot) {
  return {robot.lateral_acceleration, robot.yaw_acceleration, robot.yaw_speed, robot.yaw_jerk, robot.profile};
}

std::string to_tenths(double number) {
  const long tenths = std::lround(number * 10.0);
  const std::string whole = std::to_string(tenths / 10);
  return tenths % 10 == 0 ? whole : whole + "." + std::to_string(tenths % 10);
}
std::string millimetres(double length) { return to_tenths(length) + " mm"; }

FittedTurn turn_laid_out_for(double speed, Turn turn, const Robot& robot) {
  FittedTurn fitted{
      shape_at(turn, speed, curve_limits(robot), robot.cell), std::min(speed, turn_top_speed(turn, robot)), {}};
  TurnShape& shape = fitted.shape;
  const std::string at_speed = name_with_fit(turn, robot) + " at " + millimetres(speed) + "/s";
  if (const double lead = std::min(shape.lead_in, shape.lead_out); lead < 0.0) {
    fitted.error = at_speed + ": its curve needs " + millimetres(-lead) + " more at one end than there are";
    return fitted;
  }
  shape.clearance = clearance_of(shape, robot.cell);
  if (shape.clearance < robot.clearance)
    fitted.error = at_speed + " with a clearance of " + millimetres(robot.clearance) + ": it comes within " +
                   millimetres(shape.clearance) + " of a post or a wall";
  return fitted;
}

FittedTurn fitted_turn(Turn turn, const Robot& robot) {
  if (turn == Turn::f180) return fitted_around_post(robot);
  if (const double speed = robot.layout(turn).given; speed > 0.0) return turn_laid_out_for(speed, turn, robot);
  const int top_steps = static_cast<int>(turn_top_speed(turn, robot) / speed_step);
  FittedTurn nearest;
  double best = -1.0;
  const auto fits = [&](int steps) {
    FittedTurn fitted{shape_at(turn, steps * speed_step, curve_limits(robot), robot.cell), 0.0, {}};
    fitted.speed = std::min(steps, top_steps) * speed_step;
    if (fitted.shape.lead_in < 0.0 || fitted.shape.lead_out < 0.0) return false;
    fitted.shape.clearance = clearance_of(fitted.shape, robot.cell);
    if (fitted.shape.clearance > best) best = fitted.shape.clearance, nearest = fitted;
    return best >= robot.clearance;
  };
  for (int steps = top_steps; steps > 0; --steps)
    if (fits(steps)) return nearest;
  // If its own path would come too near to a post, a slow robot turns on that of a faster one. The curve grows with the
  // speed, until it has no room.
  const int none = static_cast<int>(2.0 * std::sqrt(robot.lateral_acceleration * robot.cell) / speed_step);
  for (int steps = top_steps + 1; steps <= none; ++steps)
    if (fits(steps)) return nearest;
  if (best >= 0.0) return {{}, 0.0, refusal_of_clearance(turn, robot, best, nearest.speed)};
  return {{},
          0.0,
          name_with_fit(turn, robot) + ": even at " + millimetres(speed_step) +
              "/s its curve is too long; increase the yaw acceleration"};
}

}  // namespace labmouse
