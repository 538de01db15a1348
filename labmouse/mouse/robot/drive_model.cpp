#include "labmouse/mouse/robot/drive_model.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/mouse/robot/fitted_turn.hpp"
#include "labmouse/mouse/robot/free_turn.hpp"
#include "labmouse/mouse/robot/search_drive.hpp"
#include "labmouse/mouse/robot/straights.hpp"
#include "labmouse/mouse/robot/turn_drive.hpp"

namespace labmouse {
namespace {

constexpr DriveTime shortest_allowed_turn = 1'000;
/// The slowest robot, in mm/s: its straights of 64 units in the largest cells still take less than no_time. Whole
/// routes that take longer do not count.
constexpr double slowest_speed = 50.0;

/// Faster than any robot, mm/s.
constexpr double no_speed = 1e9;

constexpr bool leads_back(Turn turn) { return turn == Turn::out45 || turn == Turn::out135; }

DriveTime fixed_time(const FixedTimes& fixed, Turn turn) {
  switch (turn) {
    case Turn::f45:
    case Turn::out45:
      return fixed.f45;
    case Turn::f90:
      return fixed.f90;
    case Turn::f135:
    case Turn::out135:
      return fixed.f135;
    case Turn::f180:
      return fixed.f180;
    case Turn::v90:
      return fixed.v90;
    case Turn::s90:
      return fixed.s90;
  }
  return 0;
}

std::string milliseconds(DriveTime time) {
  std::string digits = std::to_string(time % 1000 + 1000);
  digits[0] = '.';
  return std::to_string(time / 1000) + (time % 1000 == 0 ? "" : digits) + " ms";
}

DriveModel refused(std::string why) {
  DriveModel model;
  model.error = std::move(why);
  return model;
}

/// One lane along the axes and one on diagonals, without leads. As published, straights begin and end at the same speed
/// everywhere, also at the start and in the goal.
DriveModel fixed_model(const Robot& robot) {
  DriveModel model;
  DriveTables& tables = model.tables;
  tables.cell = robot.cell;
  tables.along.lanes = tables.diagonal.lanes = {{robot.fixed->speed, 0.0}};
  fill_between(tables.along, robot.cell / 2.0, limits_along(robot));
  fill_between(tables.diagonal, robot.cell / std::sqrt(2.0), limits_diagonal(robot));
  tables.start = tables.finish = tables.whole = tables.along.between;
  for (const Turn turn : all_turns) {
    if (!robot.drives(turn)) continue;
    const TurnShape shape =
        leads_back(turn) ? backwards(plain_shape(reversed(turn), robot.cell)) : plain_shape(turn, robot.cell);
    const DriveTime time = fixed_time(*robot.fixed, turn);
    const double speed = shape.whole() * 1e6 / time;
    tables.turns.push_back({turn, 0, 0, time, speed, speed});
    model.shapes.push_back(shape);
  }
  return model;
}

std::uint8_t lane_of(std::vector<Lane>& lanes, const Lane& lane) {
  const auto found = std::find(lanes.begin(), lanes.end(), lane);
  const auto index = static_cast<std::uint8_t>(found - lanes.begin());
  if (found == lanes.end()) lanes.push_back(lane);
  return index;
}

void add_turn(DriveModel& model, const TurnShape& shape, double from, double to, double seconds) {
  const auto lanes = [&](bool diagonal) -> std::vector<Lane>& {
    return diagonal ? model.tables.diagonal.lanes : model.tables.along.lanes;
  };
  DrivenTurn turn{shape.turn, 0, 0, microseconds(seconds), from, to};
  turn.from = lane_of(lanes(begins_diagonal(shape.turn)), {from, shape.lead_in});
  turn.to = lane_of(lanes(ends_diagonal(shape.turn)), {to, shape.lead_out});
  model.tables.turns.push_back(turn);
  model.shapes.push_back(shape);
}

/// Seconds of the curve of a turn between two speeds; nothing if it cannot be driven so.
std::optional<double> curve_seconds(const FittedTurn& turn, double from, double to, double top, const Robot& robot) {
  if (robot.grip <= 0.0)
    return from == to && from <= turn.speed ? std::optional(turn.shape.length / from) : std::nullopt;
  const auto drive = turn_drive(turn.shape, from, to, top, robot);
  return drive ? std::optional(drive->seconds) : std::nullopt;
}

/// Adds a turn at all of its speeds, the largest first: from each to itself, or with grip from each to every one that
/// it can reach. Of several paths each takes the best.
void add_turns(DriveModel& model, const std::vector<FittedTurn>& paths, const std::vector<double>& speeds,
               const Robot& robot) {
  for (const double from : speeds)
    for (const double to : speeds) {
      const FittedTurn* best = nullptr;
      double best_cost = 0.0, best_seconds = 0.0;
      for (const FittedTurn& path : paths) {
        const auto seconds = curve_seconds(path, from, to, speeds.front(), robot);
        if (!seconds) continue;
        const double cost = paths.size() > 1 ? cost_of(path.shape, from, to, *seconds, robot) : 0.0;
        if (best == nullptr || cost < best_cost) best = &path, best_cost = cost, best_seconds = *seconds;
      }
      if (best != nullptr) add_turn(model, best->shape, from, to, best_seconds);
    }
}

std::string refusal_of_slowest(const Robot& robot, const FittedTurn& slowest) {
  return "its turn " + std::string(name_of(slowest.shape.turn)) + " fits into cells of " + millimetres(robot.cell) +
         " only up to " + millimetres(slowest.speed) + "/s; it must be " + millimetres(slowest_speed) +
         "/s or more: increase the lateral or yaw acceleration";
}

/// The turns that a robot drives, with those back from diagonals.
std::vector<Turn> turns_of(const Robot& robot) {
  std::vector<Turn> turns;
  std::copy_if(all_turns.begin(), all_turns.end(), std::back_inserter(turns),
               [&](Turn turn) { return robot.drives(turn); });
  return turns;
}

/// The largest speed, in steps of speed_step, that it can reach from rest before the small turn that follows the first
/// wall.
double speed_by_first_wall(const Robot& robot, const TurnShape& small_turn) {
  const double way = robot.run_up + robot.cell / 2.0 + small_turn.lead_in;
  return std::floor(std::sqrt(2.0 * robot.acceleration * way) / speed_step) * speed_step;
}

/// The largest speed, in steps of speed_step, from which it can stop in the middle of the goal right after the small
/// turn.
double speed_to_stop_from(const Robot& robot, const TurnShape& small_turn) {
  const double way = robot.cell / 2.0 + small_turn.lead_out;
  return std::floor(std::sqrt(2.0 * robot.braking * way) / speed_step) * speed_step;
}

/// The speed that all turns have in common: that of the slowest one, or less where a start does not reach it or a mouse
/// cannot stop from it.
double common_speed(const Robot& robot, const std::vector<FittedTurn>& fitted) {
  double common = no_speed, small_speed = no_speed;
  for (const FittedTurn& turn : fitted) {
    common = std::min(common, turn.speed);
    if (turn.shape.turn != Turn::s90) continue;
    small_speed = speed_by_first_wall(robot, turn.shape);
    if (robot.stop == Stop::goal) small_speed = std::min(small_speed, speed_to_stop_from(robot, turn.shape));
  }
  return small_speed < common ? std::max(small_speed, slowest_speed) : common;
}

/// A speed between two others: that of the turn nearest to the middle, so that other turns can follow that one at once;
/// or the middle itself, if every turn is close to either end.
double speed_between(double low, double high, const std::vector<FittedTurn>& fitted) {
  constexpr double close = 0.1;
  const double middle = (low + high) / 2.0;
  double best = no_speed;
  for (const FittedTurn& turn : fitted) {
    const double share = (turn.speed - low) / (high - low);
    if (share > close && share < 1.0 - close && std::abs(turn.speed - middle) < std::abs(best - middle))
      best = turn.speed;
  }
  return best < no_speed ? best : middle;
}

/// The lower speeds that turns share, in order, the common one first: as many as a turn may have besides its own. The
/// widest gap below the fastest turn is split until there are enough. docs/research/timings.md has what fewer or more
/// speeds cost.
std::vector<double> levels_of(const std::vector<FittedTurn>& fitted, double common, int speeds) {
  std::vector<double> bounds = {common, common};
  for (const FittedTurn& turn : fitted) bounds.back() = std::max(bounds.back(), turn.speed);
  while (static_cast<int>(bounds.size()) < speeds) {
    std::size_t widest = 1;
    for (std::size_t i = 1; i < bounds.size(); ++i)
      if (bounds[i] - bounds[i - 1] > bounds[widest] - bounds[widest - 1]) widest = i;
    const auto gap = bounds.begin() + static_cast<std::ptrdiff_t>(widest);
    bounds.insert(gap, speed_between(gap[-1], gap[0], fitted));
  }
  bounds.pop_back();
  return bounds;
}

bool is_free(Turn turn, const Robot& robot) {
  return robot.profile == TurnProfile::free && robot.layout(turn).given <= 0.0;
}

/// The speeds of a turn: its own, and all lower ones that turns share.
std::vector<double> speeds_of(double own, const std::vector<double>& levels) {
  std::vector<double> speeds = {own};
  std::copy_if(levels.rbegin(), levels.rend(), std::back_inserter(speeds), [&](double it) { return it < own; });
  return speeds;
}

/// Lowers the first of the speeds to what the paths allow. Where their leads have changed, so have the steps in which
/// they are driven, and with them the last digits of that speed. A turn back from a diagonal brakes where the one onto
/// it speeds up.
void lower_first(std::vector<double>& speeds, const std::vector<FittedTurn>& paths, const Robot& robot) {
  double most = 0.0;
  for (const FittedTurn& path : paths) most = std::max(most, end_speed_of(path.shape, speeds.front(), robot));
  std::erase_if(speeds, [&](double speed) { return speed >= most; });
  speeds.insert(speeds.begin(), most);
}

/// Each turn at its own largest speed, and on the same path at lower ones, because a slow turn cannot follow a fast one
/// at once. A turn of free shape may have a path for each speed. With one speed only, all turns at the common one.
DriveModel model_of_speeds(const Robot& robot) {
  std::vector<FittedTurn> plain, fitted;
  for (const Turn turn : turns_of(robot)) {
    if (leads_back(turn)) {
      const auto onto = std::find_if(plain.begin(), plain.end(),
                                     [&](const FittedTurn& it) { return it.shape.turn == reversed(turn); });
      const auto place = onto - plain.begin();
      plain.push_back(*onto);
      fitted.push_back(fitted[static_cast<std::size_t>(place)]);
      continue;
    }
    plain.push_back(fitted_turn(turn, robot));
    if (!plain.back().error.empty()) return refused(plain.back().error);
    fitted.push_back(is_free(turn, robot) ? freed(plain.back(), turn_top_speed(turn, robot), robot) : plain.back());
  }
  const FittedTurn slowest = *std::min_element(
      fitted.begin(), fitted.end(), [](const FittedTurn& a, const FittedTurn& b) { return a.speed < b.speed; });
  if (slowest.speed < slowest_speed) return refused(refusal_of_slowest(robot, slowest));
  const std::vector<double> levels =
      levels_of(fitted, std::min(common_speed(robot, plain), slowest.speed), robot.speeds);
  DriveModel model;
  const std::vector<Turn> turns = turns_of(robot);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const double own = robot.speeds > 1 ? fitted[i].speed : levels.front();
    std::vector<double> speeds = speeds_of(own, levels);
    std::vector<FittedTurn> paths = {fitted[i]};
    if (is_free(turns[i], robot))
      for (const double speed : speeds)
        if (speed < fitted[i].speed) paths.push_back(freed(plain[i], speed, robot));
    if (leads_back(turns[i]))
      for (FittedTurn& path : paths) path.shape = backwards(path.shape);
    if (is_free(turns[i], robot) && robot.grip > 0.0) {
      share_leads(paths);
      lower_first(speeds, paths, robot);
    }
    add_turns(model, paths, speeds, robot);
  }
  model.tables.cell = robot.cell;
  fill_between(model.tables.along, robot.cell / 2.0, limits_along(robot));
  fill_between(model.tables.diagonal, robot.cell / std::sqrt(2.0), limits_diagonal(robot));
  fill_ends(model.tables, robot);
  return model;
}

std::string refusal_of_limits(const Robot& robot) {
  for (const double limit : {robot.cell, robot.speed, robot.speed_diagonal, robot.acceleration,
                             robot.acceleration_diagonal, robot.braking, robot.braking_diagonal})
    if (!(limit > 0.0)) return "its cell side, speeds, accelerations and brakings must be greater than 0";
  if (const double speed = std::min(robot.speed, robot.speed_diagonal); speed < slowest_speed)
    return "its straights must be driven at " + millimetres(slowest_speed) + "/s or more, not at " +
           millimetres(speed) + "/s";
  return "";
}

std::string refusal_of_fixed(const Robot& robot) {
  const FixedTimes& fixed = *robot.fixed;
  if (!(fixed.speed > 0.0 && fixed.speed <= std::min(robot.speed, robot.speed_diagonal)))
    return "its speed at nodes, " + millimetres(fixed.speed) +
           "/s, must be more than 0 and at most that of its straights, " + millimetres(robot.speed) +
           "/s, and diagonals, " + millimetres(robot.speed_diagonal) + "/s";
  if (fixed.speed < slowest_speed)
    return "its speed at nodes, " + millimetres(fixed.speed) + "/s, must be " + millimetres(slowest_speed) +
           "/s or more";
  return "";
}

std::string refusal_of_grip(const Robot& robot) {
  if (robot.grip <= 0.0) return "";
  if (robot.yaw_jerk > 0.0)
    return "a limit of yaw jerk and a grip do not go together: where the speed changes in a curve, so would the yaw "
           "jerk; leave one of them out";
  const double most = std::max({robot.lateral_acceleration, robot.acceleration, robot.braking,
                                robot.acceleration_diagonal, robot.braking_diagonal});
  if (robot.grip < most)
    return "its grip, " + millimetres(robot.grip) + "/s², is less than another of its accelerations, " +
           millimetres(most) + "/s²; it is what the tyres hold in any direction, and so the largest of them";
  return "";
}

std::string refusal_of_curves(const Robot& robot) {
  if (!(robot.lateral_acceleration > 0.0 && robot.yaw_acceleration > 0.0))
    return "its lateral acceleration and yaw acceleration must be greater than 0";
  if (std::string why = refusal_of_grip(robot); !why.empty()) return why;
  if (robot.speeds < 1 || robot.speeds > most_speeds)
    return "its turns must have 1 to " + std::to_string(most_speeds) + " speeds each, not " +
           std::to_string(robot.speeds);
  if (!(robot.clearance >= 0.0 && robot.run_up >= 0.0)) return "its clearance and run-up must be 0 or more";
  if (robot.run_up >= robot.cell / 2.0)
    return "a run-up of " + millimetres(robot.run_up) + " begins behind the wall of the start cell, which is " +
           millimetres(robot.cell / 2.0) + " from the middle";
  // A diagonal through the middles of walls passes posts at cell / sqrt(8).
  if (const double room = robot.cell / std::sqrt(8.0); robot.clearance > room)
    return "a clearance of " + millimetres(robot.clearance) + " does not fit diagonals in cells of " +
           millimetres(robot.cell) + ", which pass posts at " + millimetres(room);
  return "";
}

std::string refusal_of_turn_times(const DriveTables& tables) {
  for (const DrivenTurn& turn : tables.turns)
    if (turn.time < shortest_allowed_turn)
      return "its turn " + std::string(name_of(turn.turn)) + " takes " + milliseconds(turn.time) +
             "; a turn must take at least 1 ms";
  return "";
}

/// Checks that every maze that can be searched can be run: all turns follow each other at the slowest speed, if the
/// start reaches it and the mouse can stop from it.
std::string refusal_of_ends(const DriveTables& tables) {
  const auto slowest = std::find_if(tables.turns.rbegin(), tables.turns.rend(),
                                    [](const DrivenTurn& turn) { return turn.turn == Turn::s90; });
  if (tables.start_to(1, slowest->from) >= no_time)
    return "from rest in the start cell it does not reach the speed of its slowest turns, " +
           millimetres(slowest->speed) + "/s, by the first wall; increase the acceleration or run-up";
  if (tables.finish_from(1, slowest->to, 0) >= no_time)
    return "from the speed of its slowest turns, " + millimetres(slowest->speed) +
           "/s, it does not stop within half a cell, in the middle of its goal; increase the braking, or let it run on "
           "with stop = \"beyond\"";
  return "";
}

/// The model of a robot, or the reason why it is refused.
DriveModel model_of(const Robot& robot) {
  if (std::string why = refusal_of_limits(robot); !why.empty()) return refused(std::move(why));
  if (std::string why = robot.fixed ? refusal_of_fixed(robot) : refusal_of_curves(robot); !why.empty())
    return refused(std::move(why));
  DriveModel model = robot.fixed ? fixed_model(robot) : model_of_speeds(robot);
  if (!model.error.empty()) return model;
  if (std::string why = refusal_of_turn_times(model.tables); !why.empty()) return refused(std::move(why));
  if (std::string why = refusal_of_ends(model.tables); !why.empty()) return refused(std::move(why));
  model.robot = robot;
  const FittedTurn small = search_turn(robot, model.tables.turns, model.shapes);
  const SearchModel search = search_model(robot, small.shape, small.speed);
  if (!search.error.empty()) return refused(search.error);
  model.search = search.drive;
  model.tables.hash = hash_of(model.tables);
  return model;
}

/// If an optional limit of curves is the cause of a refusal, adds its name.
DriveModel with_cause(DriveModel refusal, const Robot& robot) {
  struct Limit {
    double Robot::*value;
    std::string_view words, key, unit;
  };
  for (const Limit& limit : {Limit{&Robot::yaw_speed, "yaw speed", "curve.yaw_speed", "rad/s"},
                             Limit{&Robot::yaw_jerk, "yaw jerk", "curve.yaw_jerk", "rad/s³"}}) {
    Robot free = robot;
    free.*limit.value = 0.0;
    if (robot.*limit.value <= 0.0 || !model_of(free).error.empty()) continue;
    refusal.error += "; what is in its way is its " + std::string(limit.words) + ", " + to_tenths(robot.*limit.value) +
                     " " + std::string(limit.unit) + " (" + std::string(limit.key) + "): without it, it would do";
    return refusal;
  }
  return refusal;
}

}  // namespace

DriveModel make_drive_model(const Robot& robot) {
  DriveModel model = model_of(robot);
  return model.error.empty() ? model : with_cause(std::move(model), robot);
}

}  // namespace labmouse
