#include "labmouse/lab/robots/robot_data.hpp"

#include <algorithm>
#include <utility>

#include "labmouse/lab/robots/robot_json.hpp"
#include "labmouse/lab/robots/robot_remarks.hpp"
#include "labmouse/lab/robots/robot_table.hpp"
#include "labmouse/lab/system/version.hpp"

namespace labmouse {
namespace {

double ms_of(DriveTime time) { return time / 1e3; }

Json turn_data(const Robot& robot, const TurnShape& shape) {
  // If the robot file gives times, the real curve is not known.
  const auto known = [&](double value) { return robot.fixed ? Json(nullptr) : Json(value); };
  return {{"turn", name_of(shape.turn)},       {"speeds", Json::array()},       {"lead_in", known(shape.lead_in)},
          {"lead_out", known(shape.lead_out)}, {"length", known(shape.length)}, {"clearance", known(shape.clearance)}};
}

/// Null for a robot without such straights.
Json straight_data(std::string_view kind, const StraightTimes& times, int units_a_step, const char* step) {
  if (times.lanes.empty()) return {};
  Json list = Json::array();
  const auto slowest =
      static_cast<std::size_t>(std::min_element(times.lanes.begin(), times.lanes.end(),
                                                [](const Lane& a, const Lane& b) { return a.speed < b.speed; }) -
                               times.lanes.begin());
  for (const int steps : {1, 2, 4, 8, 16})
    if (const DriveTime time = times.at(steps * units_a_step, slowest, slowest); time < no_time)
      list.push_back({{"steps", steps}, {"ms", ms_of(time)}});
  return {{"kind", kind}, {"step", step}, {"speed", times.lanes[slowest].speed}, {"times", std::move(list)}};
}

}  // namespace

Json turns_data(const Robot& robot, const DriveModel& model) {
  Json turns = Json::array();
  for (const std::size_t i : shown_turns(model)) {
    const DrivenTurn& turn = model.tables.turns[i];
    if (turns.empty() || turns.back()["turn"] != name_of(turn.turn)) turns.push_back(turn_data(robot, model.shapes[i]));
    turns.back()["speeds"].push_back({{"speed", turn.speed}, {"ms", ms_of(turn.time)}});
  }
  return turns;
}

Json straights_data(const Robot& robot, const DriveModel& model) {
  Json straights = Json::array();
  straights.push_back(straight_data("straight", model.tables.along, 2, "cells"));
  if (robot.diagonals) straights.push_back(straight_data("diagonal", model.tables.diagonal, 1, "half diagonals"));
  straights.erase(std::remove(straights.begin(), straights.end(), Json()), straights.end());
  return straights;
}

Json search_data(const SearchDrive& search) {
  return {{"cell", ms_of(search.cell)},           {"turn", ms_of(search.turn)},
          {"back", ms_of(search.back)},           {"quarter", ms_of(search.quarter)},
          {"half_cell", ms_of(search.half_cell)}, {"known_2", ms_of(search.dash(2))},
          {"known_8", ms_of(search.dash(8))}};
}

Json robot_data(const Robot& robot, const DriveModel& model) {
  return {{"labmouse", version()},
          {"robot", robot_json(robot, RobotParts::with_body)},
          {"turns", turns_data(robot, model)},
          {"straights", straights_data(robot, model)},
          {"search", search_data(model.search)},
          {"tables", hash_words(model.tables)},
          {"remarks", robot_remarks(robot, model)}};
}

}  // namespace labmouse
