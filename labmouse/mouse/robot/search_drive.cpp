#include "labmouse/mouse/robot/search_drive.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "labmouse/functions/angles.hpp"
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

/// A straight on which a mouse changes between two speeds, in either order.
struct Change {
  double speed = 0.0;  ///< mm/s at the edge of the cell
  double other = 0.0;  ///< mm/s in the curve
  double rate = 0.0;   ///< mm/s²

  double way() const { return std::abs(speed * speed - other * other) / (2.0 * rate); }
  /// Seconds over a lead that is long enough; the rest of it is driven at the speed of the edge.
  double seconds(double lead) const { return 2.0 * way() / (speed + other) + (lead - way()) / speed; }
};

/// A quarter turn from edge to edge at a speed of its own. The mouse changes to it and back on the leads: at the edge
/// it has just seen where it can go.
struct OwnTurn {
  double seconds = 0.0;
  std::string error;
};
OwnTurn own_turn(const Robot& robot) {
  const double speed = robot.search_speed, own = robot.search_turn_speed;
  const FittedTurn turn = turn_laid_out_for(own, Turn::s90, robot);
  if (!turn.error.empty()) return {0.0, turn.error + "; change search.turn_speed"};
  const auto [lead_in, lead_out] = std::pair(turn.shape.lead_in, turn.shape.lead_out);
  const double up = robot.acceleration, down = robot.braking;
  const Change before{speed, own, own < speed ? down : up}, after{speed, own, own < speed ? up : down};
  if (before.way() > lead_in || after.way() > lead_out)
    return {0.0, "from its search speed, " + millimetres(speed) + "/s, to that of its search turns, " +
                     millimetres(own) + "/s, it takes " + millimetres(std::max(before.way(), after.way())) +
                     ", and the curve leaves " + millimetres(lead_in) + " to the edge of the cell; bring " +
                     "search.speed and search.turn_speed closer together"};
  return {before.seconds(lead_in) + turn.shape.length / own + after.seconds(lead_out), ""};
}

/// The times of a search cell by cell, as the robot gives them or as they follow from its search speed.
SearchModel cell_by_cell(const Robot& robot, const TurnShape& small_turn, double small_turn_speed) {
  if (robot.search.cell != 0) return {robot.search, {}};
  const double speed = robot.search_speed;
  if (!(speed > 0.0 && robot.pivot_speed > 0.0 && robot.pivot_acceleration > 0.0))
    return {{}, "its search speed, pivot speed and pivot acceleration must be greater than 0"};
  if (std::string why = refusal(robot, small_turn_speed); !why.empty()) return {{}, std::move(why)};
  const double slower = std::min(robot.acceleration, robot.braking);
  SearchDrive drive;
  drive.cell = microseconds(robot.cell / speed);
  drive.turn = microseconds(small_turn.whole() / speed);
  if (robot.search_turn_speed > 0.0) {
    const OwnTurn own = own_turn(robot);
    if (!own.error.empty()) return {{}, own.error};
    drive.turn = microseconds(own.seconds);
  }
  drive.half_cell = microseconds(speed / slower + (robot.cell / 2.0 - speed * speed / (2.0 * slower)) / speed);
  drive.quarter = microseconds(pivot_seconds(robot, pi / 2.0));
  drive.back = 2 * drive.half_cell + microseconds(pivot_seconds(robot, pi));
  return {drive, {}};
}

/// Adds dashes over known cells, from and to the speed at which the robot searches.
void add_dashes(const Robot& robot, SearchModel& model) {
  const double speed = robot.search.cell != 0 ? robot.cell / (robot.search.cell / 1e6) : robot.search_speed;
  if (robot.known_speed <= speed) {
    model.error = "its speed over known cells, " + millimetres(robot.known_speed) +
                  "/s, is not above that of its search, " + millimetres(speed) + "/s; raise or omit search.known_speed";
    return;
  }
  const double given = robot.known_acceleration, least = std::min(robot.acceleration, robot.braking);
  const double rate = given > 0.0 ? given : least;
  for (std::size_t halves = 1; halves < model.drive.onward.size(); ++halves) {
    const double length = static_cast<double>(halves) * robot.cell / 2.0;
    model.drive.onward[halves] = microseconds(seconds_onward(length, speed, {robot.known_speed, rate, rate}));
  }
}

}  // namespace

SearchModel search_model(const Robot& robot, const TurnShape& small_turn, double small_turn_speed) {
  SearchModel model = cell_by_cell(robot, small_turn, small_turn_speed);
  if (!model.error.empty()) return model;
  if (robot.known_speed > 0.0)
    add_dashes(robot, model);
  else if (robot.known_acceleration > 0.0)
    model.error = "search.known_acceleration has no effect without search.known_speed";
  return model;
}

FittedTurn search_turn(const Robot& robot, const std::vector<DrivenTurn>& turns, const std::vector<TurnShape>& shapes) {
  if (robot.profile == TurnProfile::free && !robot.fixed) return fitted_turn(Turn::s90, robot);
  const auto small =
      std::find_if(shapes.begin(), shapes.end(), [](const TurnShape& shape) { return shape.turn == Turn::s90; });
  return {*small, turns[static_cast<std::size_t>(small - shapes.begin())].speed, {}};
}

}  // namespace labmouse
