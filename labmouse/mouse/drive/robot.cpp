#include "labmouse/mouse/drive/robot.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/mouse/drive/straights.hpp"

namespace labmouse {
namespace {

/// A shortest way enters each of the 32 x 32 cells at most twice, straight on or by a small turn. At half a second each
/// that stays below no_time.
constexpr DriveTime longest_cell = 500'000;
constexpr DriveTime shortest_allowed_turn = 1'000;

DriveTime fixed_time(const FixedTimes& fixed, Turn turn) {
  switch (turn) {
    case Turn::f45:
    case Turn::out45: return fixed.f45;
    case Turn::f90: return fixed.f90;
    case Turn::f135:
    case Turn::out135: return fixed.f135;
    case Turn::f180: return fixed.f180;
    case Turn::v90: return fixed.v90;
    case Turn::s90: return fixed.s90;
  }
  return 0;
}

/// One lane along and one diagonal, without leads. The published straights begin and end at that one speed everywhere, at
/// the start and in the goal too.
DriveTables fixed_tables(const Robot& robot) {
  DriveTables tables;
  tables.cell = robot.cell;
  const Lane lane{robot.fixed->speed, 0.0};
  tables.along.lanes = {lane};
  tables.diagonal.lanes = {lane};
  fill_between(tables.along, robot.cell / 2.0, limits_along(robot));
  fill_between(tables.diagonal, robot.cell / std::sqrt(2.0), limits_diagonal(robot));
  tables.start = tables.finish = tables.whole = tables.along.between;
  for (const Turn turn : all_turns)
    tables.turns.push_back({turn, 0, 0, fixed_time(*robot.fixed, turn), robot.fixed->speed});
  return tables;
}

std::string millimetres(double length) { return std::to_string(std::lround(length)) + " mm"; }

std::string milliseconds(DriveTime time) {
  const std::string thousandths = std::to_string(time % 1000);
  return std::to_string(time / 1000) + "." + std::string(3 - thousandths.size(), '0') + thousandths + " ms";
}

/// Why routes could last too long or turns too short for tables of whole microseconds; nothing where all is well.
std::string refusal_of_times(const DriveTables& tables) {
  double slowest = tables.along.lanes.front().speed;
  for (const DrivenTurn& turn : tables.turns) slowest = std::min(slowest, turn.speed);
  if (tables.cell * 1e6 > slowest * longest_cell)
    return "its slowest turn is driven at " + millimetres(slowest) + "/s, where a cell of " + millimetres(tables.cell) +
           " takes more than 500 ms: at least " + millimetres(std::ceil(tables.cell * 2.0)) + "/s are needed";
  for (const DrivenTurn& turn : tables.turns) {
    const std::string it = "its turn " + std::string(name_of(turn.turn)) + " takes " + milliseconds(turn.time);
    if (turn.time < shortest_allowed_turn) return it + ": a turn takes at least 1 ms";
    if (turn.turn == Turn::s90 && turn.time > longest_cell) return it + ": it may take 500 ms";
  }
  return "";
}

std::string refusal_of_limits(const Robot& robot) {
  for (const double limit : {robot.cell, robot.speed, robot.speed_diagonal, robot.acceleration,
                             robot.acceleration_diagonal, robot.braking, robot.braking_diagonal})
    if (!(limit > 0.0)) return "its cell side, speeds, accelerations and brakings must be greater than 0";
  const double top = std::min(robot.speed, robot.speed_diagonal);
  if (robot.fixed && !(robot.fixed->speed > 0.0 && robot.fixed->speed <= top))
    return "its speed at nodes, " + millimetres(robot.fixed->speed) + "/s, must be more than 0 and at most that of its " +
           "straights and diagonals, " + millimetres(top) + "/s";
  return "";
}

DriveModel refused(std::string why) {
  DriveModel model;
  model.error = std::move(why);
  return model;
}

}  // namespace

DriveModel make_drive_model(const Robot& robot) {
  if (std::string why = refusal_of_limits(robot); !why.empty()) return refused(std::move(why));
  if (!robot.fixed) return refused("robots without fixed times are not known yet");
  DriveModel model;
  model.tables = fixed_tables(robot);
  if (std::string why = refusal_of_times(model.tables); !why.empty()) return refused(std::move(why));
  model.tables.hash = hash_of(model.tables);
  model.search = robot.search;
  return model;
}

}  // namespace labmouse
