// The robot editor: values of a robot, their errors, and the turns, times and route that result.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/drive_choices.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/page/robot_request.hpp"
#include "labmouse/lab/replays/play_seconds.hpp"
#include "labmouse/lab/robots/robot_data.hpp"
#include "labmouse/lab/robots/robot_file.hpp"
#include "labmouse/lab/robots/robot_keys.hpp"
#include "labmouse/lab/robots/robot_remarks.hpp"
#include "labmouse/lab/robots/robot_table.hpp"
#include "labmouse/lab/robots/robot_text.hpp"
#include "labmouse/lab/routes/route_data.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/robot/turn_room.hpp"

namespace labmouse {
namespace {

/// A wall as the line between its posts, in cells from a corner.
Json wall_line(Wall wall, Cell corner) {
  const int x = wall.cell.x - corner.x, y = wall.cell.y - corner.y;
  return wall.side == Heading::north ? Json{x, y + 1, x + 1, y + 1} : Json{x + 1, y, x + 1, y + 1};
}

Json wall_lines(const std::vector<Wall>& walls, Cell corner) {
  Json lines = Json::array();
  for (const Wall wall : walls) lines.push_back(wall_line(wall, corner));
  return lines;
}

/// The path of a turn in cells from the corner: straight lead, curve, straight lead.
Json turn_path(const TurnShape& shape, const TurnRoom& room, Cell corner, double cell) {
  constexpr int pieces = 24;
  Json points = Json::array();
  const auto add = [&](double distance) {
    const MazePoint point = maze_point(room.from, true, shape.at(distance), cell);
    points.push_back({std::round((point.x - corner.x) * 1e4) / 1e4, std::round((point.y - corner.y) * 1e4) / 1e4});
  };
  add(0.0);
  for (int i = 0; i <= pieces; ++i) add(shape.lead_in + shape.length * i / pieces);
  add(shape.whole());
  return points;
}

/// Adds to each kind of turn its path, which does not depend on the speed, and the walls around it.
Json turns_json(const Robot& robot, const DriveModel& model) {
  Json turns = turns_data(robot, model);
  std::size_t next = 0;
  for (const std::size_t i : shown_turns(model)) {
    const TurnShape& shape = model.shapes[i];
    if (next == turns.size() || turns[next]["turn"] != name_of(shape.turn)) continue;
    const TurnRoom room = room_of(shape.turn);
    // The panel shows 2×2 cells; the turn begins in the south-eastern one or on its northern side.
    const Cell corner = neighbour(room.from.cell, Heading::west);
    Json& turn = turns[next++];
    turn["path"] = turn_path(shape, room, corner, robot.cell);
    turn["open"] = wall_lines(room.open, corner);
    turn["standing"] = wall_lines(room.standing, corner);
  }
  return turns;
}

Json robot_result(const Robot& robot, const DriveModel& model) {
  return {{"line", robot_line(robot, model)},
          {"turns", turns_json(robot, model)},
          {"straights", straights_data(robot, model)},
          {"search", search_data(model.search)},
          {"tables", hash_words(model.tables)}};
}

/// Adds the best route of a maze with its path, or the reason why there is none.
void add_route(const NamedMaze& maze, const DriveModel& model, Json& answer) {
  const RouteReport report = route_report(maze.maze, model);
  answer["no_route"] = report.error;
  if (!report.error.empty()) return;
  answer["route"] = route_json(report, maze.name, model);
  answer["route"]["path"] = path_json(path_of(report.route, 0, model));
}

Json place_json(std::string_view sentence) { return {{"key", key_in(sentence)}, {"text", sentence}}; }

Json remarks_json(const Robot& robot, const DriveModel& model) {
  Json remarks = Json::array();
  for (const std::string& remark : robot_remarks(robot, model)) remarks.push_back(place_json(remark));
  return remarks;
}

Json problems_json(const std::vector<Problem>& problems) {
  Json list = Json::array();
  for (const Problem& problem : problems) {
    Json& json = list.emplace_back(place_json(problem.reason));
    json["line"] = problem.line;
    json["column"] = problem.column;
  }
  return list;
}

/// The names of the keys that have an effect together with those values.
Json keys_of(const Json& values) {
  RobotForms forms;
  for (const auto& [name, value] : values.items()) {
    forms.turns = forms.turns || name.starts_with("turns.");
    forms.body = forms.body || is_body_section(name.substr(0, name.find('.')));
  }
  forms.search_times = values.contains("search.cell");
  forms.infrared_list = values.contains(std::string(infrared_list));
  forms.ranger_list = values.contains(std::string(ranger_list));
  forms.diagonals = values.value("diagonals", Json(true)) != Json(false);
  Json keys = Json::array();
  for (const RobotKey& key : robot_keys())
    if (forms.has(key) || values.contains(std::string(key.name))) keys.push_back(key.name);
  return keys;
}

}  // namespace

PageReply answer_robot(const ReadJson& json, std::string_view bytes) {
  PageRequest request(json);
  const std::string name = request.text("name");
  std::optional<NamedMaze> maze;
  if (request.has("maze")) maze = request.maze();
  const std::string text = robot_text_of(request, bytes);
  if (!request.error().empty()) return failed(request.error());
  RobotResult read = read_robot(text, name);
  const Json values = robot_values(text);
  Json answer = {{"text", text},
                 {"values", values},
                 {"keys", keys_of(values)},
                 {"problems", problems_json(read.problems)},
                 {"remarks", Json::array()},
                 {"result", nullptr},
                 {"route", nullptr},
                 {"no_route", ""}};
  if (read.robot) {
    answer["remarks"] = remarks_json(*read.robot, read.model);
    answer["result"] = robot_result(*read.robot, read.model);
    if (maze) add_route(*maze, read.model, answer);
  }
  return answered(std::move(answer));
}

Json page_robot_keys_json() {
  using With = RobotKey::With;
  using Kind = RobotKey::Kind;
  constexpr std::array with = {"always", "curves", "turns", "search_speed", "search_times", "body"};
  constexpr std::array kinds = {"number", "whole", "number_or_false", "yes_or_no", "choice"};
  static_assert(static_cast<std::size_t>(With::body) + 1 == with.size());
  static_assert(static_cast<std::size_t>(Kind::choice) + 1 == kinds.size());
  Json list = Json::array();
  for (const RobotKey& key : robot_keys())
    list.push_back({{"name", key.name},
                    {"meaning", key.meaning},
                    {"unit", key.unit},
                    {"range", range_of(key)},
                    {"low", key.low},
                    {"high", key.high},
                    {"with", with[static_cast<std::size_t>(key.with)]},
                    {"needed", key.needed && key.sensor == RobotKey::Sensor::none},
                    {"kind", kinds[static_cast<std::size_t>(key.kind)]},
                    {"choices", std::vector<std::string_view>(key.choices.begin(), key.choices.end())},
                    {"of_diagonals", key.of_diagonals}});
  return list;
}

}  // namespace labmouse
