// Lists everything built in; version, signature and speed.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "labmouse/contest/rules.hpp"
#include "labmouse/lab/bench/distance_speed.hpp"
#include "labmouse/lab/bench/signature.hpp"
#include "labmouse/lab/bench/speed_json.hpp"
#include "labmouse/lab/mazes/builtin_mazes.hpp"
#include "labmouse/lab/mice/mice_json.hpp"
#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/drive_choices.hpp"
#include "labmouse/lab/page/page_world.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/robots/builtin_rules.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/worlds/entering.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

template <class Things>
Json named(const Things& things) {
  Json list = Json::array();
  for (const auto* thing : things) list.push_back({{"name", thing->name}, {"summary", thing->summary}});
  return list;
}

/// The list of built-in mice, in which each type of parameter is a single word.
Json mice() {
  const std::map<std::string, std::string> types = {{"whole number", "whole"}, {"number", "real"}, {"yes/no", "flag"}};
  Json list = mice_json();
  for (Json& mouse : list) {
    for (Json& parameter : mouse["parameters"])
      if (const auto type = types.find(parameter["type"].get<std::string>()); type != types.end())
        parameter["type"] = type->second;
  }
  return list;
}

Json mazes() {
  Json list = Json::array();
  for (const BuiltinMaze& builtin : builtin_mazes()) {
    const Size size = read_maze(builtin.text).maze->size();
    list.push_back({{"name", builtin.name}, {"width", size.width}, {"height", size.height}});
  }
  return list;
}

/// The choices of a setting: its words and the names of built-in things; null if it has none.
Json choices_of(const WorldSetting& setting) {
  Json names;
  for (const std::string_view choice : setting.choices) names.push_back(choice);
  if (setting.name == "robot")
    for (const BuiltinRobot& robot : builtin_robots()) names.push_back(robot.name);
  if (setting.name == "rules")
    for (const BuiltinRules& rules : builtin_rules()) names.push_back(rules.name);
  if (setting.brought != nullptr)
    for (const std::string& name : setting.brought()) names.push_back(name);
  return names;
}

/// A setting of a world, in the form of parameters of mice.
Json setting_json(const WorldSetting& setting) {
  using Kind = WorldSetting::Kind;
  Json json = {{"name", setting.name}, {"default", setting.default_value}, {"meaning", setting.meaning}};
  json["type"] = setting.kind == Kind::whole ? "whole" : setting.kind == Kind::flag ? "flag" : "text";
  if (setting.kind == Kind::whole) {
    json["low"] = static_cast<std::int64_t>(setting.low);
    json["high"] = std::min(static_cast<std::int64_t>(setting.high), std::int64_t{most_page_steps});
  }
  if (Json choices = choices_of(setting); !choices.empty()) {
    json["type"] = "choice";
    if (!setting.half_size_default.empty()) {
      choices.insert(choices.begin(), by_maze_size);
      json["default"] = by_maze_size;
      json["by_size"] = {setting.default_value, setting.half_size_default};
    }
    json["choices"] = std::move(choices);
  }
  // A choice takes one value, and that may be the text of a robot file, which has commas itself.
  if (setting.listed && json["type"] != "choice") json["listed"] = true;
  return json;
}

/// The worlds in which built-in mice race.
Json worlds() {
  Json list = Json::array();
  for (const WorldEntry* entry : all_worlds()) {
    Json settings = Json::array(), mice = Json::array();
    for (const WorldSetting& setting : entry->settings) settings.push_back(setting_json(setting));
    const auto world = entry->make({}).world;
    for (const Contestant& mouse : residents_of(*world)) mice.push_back(mouse.name);
    if (mice.empty()) continue;
    list.push_back({{"name", entry->name},
                    {"summary", entry->summary},
                    {"in_steps", world->traits().rules_in_steps.has_value()},
                    {"plays", entry->records != nullptr},
                    {"is_stochastic", world->traits().is_stochastic},
                    {"usual_runs", entry->usual_runs},
                    {"settings", std::move(settings)},
                    {"mice", std::move(mice)}});
  }
  return list;
}

/// An example in which the map differs from the truth. The mouse detects a false wall and later corrects it, reaches
/// the goal in a speed run, crashes in the next, and is faster in the last.
Json parting() {
  return {{"world", "physical"},
          {"mouse", "festina"},
          {"maze", "contest-01"},
          {"seed", 8307636485000989},
          {"settings", Json::object()}};
}

Json rules_of_capstone() {
  const Rules rules;
  return {{"budget", rules.budget},
          {"search_factor", rules.search_factor},
          {"stride", rules.stride},
          {"failure_score", rules.failure_score}};
}

}  // namespace

PageReply answer_about(const ReadJson&, std::string_view) {
  return answered({{"version", version()},
                   {"compiler", compiler()},
                   {"mice", mice()},
                   {"mazes", mazes()},
                   {"formats", named(all_formats())},
                   {"generators", named(all_generators())},
                   {"rules", rules_of_capstone()},
                   {"worlds", worlds()},
                   {"parting", parting()},
                   {"most_side", max_side},
                   {"robots", page_robots_json()},
                   {"robot_keys", page_robot_keys_json()},
                   {"drive_rules", page_rules_json()}});
}

PageReply answer_signature(const ReadJson&, std::string_view) { return answered({{"signature", signature()}}); }

PageReply answer_speed(const ReadJson&, std::string_view) {
  return answered({{"distance_ns", distance_json(measure_distances())}});
}

}  // namespace labmouse
