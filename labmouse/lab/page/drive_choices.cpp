#include "labmouse/lab/page/drive_choices.hpp"

#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/robots/builtin_rules.hpp"
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "labmouse/lab/robots/robot_file.hpp"

namespace labmouse {

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
