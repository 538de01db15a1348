#include "labmouse/lab/robots/robot_files.hpp"

#include <fmt/format.h>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/robots/robot_remarks.hpp"
#include "labmouse/lab/system/named_text.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

FoundRobot found(const std::string& name, std::string_view text) {
  RobotResult read = read_robot(text, name);
  if (read.robot) {
    FoundRobot robot{std::move(*read.robot), std::move(read.model), {}, {}};
    for (const std::string& remark : robot_remarks(robot.robot, robot.model))
      robot.remarks.push_back(fmt::format("{}: {}", shown(name), remark));
    return robot;
  }
  FoundRobot none;
  for (const Problem& problem : read.problems) none.errors.push_back(describe(name, problem));
  return none;
}

}  // namespace

FoundRobot find_robot(const std::string& name) {
  const NamedText text = find_text("robot", builtin_robots(), name);
  if (!text.error.empty()) return {{}, {}, {text.error}, {}};
  return found(name_alone(name), text.text);
}

}  // namespace labmouse
