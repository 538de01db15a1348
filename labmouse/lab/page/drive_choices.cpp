#include "labmouse/lab/page/drive_choices.hpp"

#include <fmt/format.h>

#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/robots/builtin_rules.hpp"
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "labmouse/lab/robots/robot_file.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/robots/robot_json.hpp"

namespace labmouse {

namespace {

PageRobot built_in(const std::string& name) {
  for (const BuiltinRobot& robot : builtin_robots())
    if (robot.name == name) return {read_robot(robot.text, robot.name).model, ""};
  return {{}, fmt::format("the page has no robot '{}'", name)};
}

}  // namespace

PageRobot page_robot(const ReadJson& robot) {
  if (robot.is_object()) {
    JsonFields fields(robot, "robot");
    DriveModel model = read_robot_json(fields, robot);
    return {std::move(model), fields.error()};
  }
  if (!robot.is_string()) return {{}, "'robot' is neither a name nor a robot"};
  const std::string name = robot.get<std::string>();
  if (name.find('\n') == std::string::npos) return built_in(name);
  FoundRobot found = find_robot(name);
  return {std::move(found.model), found.errors.empty() ? "" : found.errors.front()};
}

std::optional<DriveRules> page_rules(std::string_view name) {
  for (const BuiltinRules& rules : builtin_rules())
    if (rules.name == name) return read_drive_rules(rules.text, rules.name).rules;
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
  for (const BuiltinRules& rules : builtin_rules())
    list.push_back({{"name", rules.name}, {"source", read_drive_rules(rules.text, rules.name).rules->source}});
  return list;
}

}  // namespace labmouse
