#include "labmouse/lab/page/drive_choices.hpp"

#include <array>

#include "labmouse/lab/builtin_robots.hpp"
#include "labmouse/lab/robot_file.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::ordered_json;

DriveRules rules_of(const char* name, const char* source, int divisor, bool gate_to_gate) {
  DriveRules rules;
  rules.name = name;
  rules.source = source;
  rules.time_limit = 600'000'000;
  rules.maze_time_divisor = divisor;
  rules.gate_to_gate = gate_to_gate;
  return rules;
}

const std::array<DriveRules, 2>& all_rules() {
  static const std::array<DriveRules, 2> rules = {
      rules_of("all-japan", "the fastest of at most five runs in the time given", 0, true),
      rules_of("thirtieth", "a run and a thirtieth of the time in the maze before it", 30, true)};
  return rules;
}

}  // namespace

std::optional<DriveModel> page_robot(std::string_view name) {
  for (const BuiltinRobot& robot : builtin_robots())
    if (robot.name == name) return read_robot(robot.text, robot.name).model;
  return std::nullopt;
}

std::optional<DriveRules> page_rules(std::string_view name) {
  for (const DriveRules& rules : all_rules())
    if (rules.name == name) return rules;
  return std::nullopt;
}

Json page_robots_json() {
  Json list = Json::array();
  for (const BuiltinRobot& robot : builtin_robots())
    list.push_back({{"name", robot.name}, {"cell", read_robot(robot.text, robot.name).robot->cell}});
  return list;
}

Json page_rules_json() {
  Json list = Json::array();
  for (const DriveRules& rules : all_rules()) list.push_back({{"name", rules.name}, {"source", rules.source}});
  return list;
}

}  // namespace labmouse
