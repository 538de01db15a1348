#include "labmouse/lab/robots/robot_files.hpp"

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/system/named_text.hpp"

namespace labmouse {
namespace {

FoundRobot found(const std::string& name, std::string_view text) {
  RobotResult read = read_robot(text, name);
  if (read.robot) return {std::move(*read.robot), std::move(read.model), {}};
  FoundRobot none;
  for (const Problem& problem : read.problems) none.errors.push_back(describe(name, problem));
  return none;
}

}  // namespace

FoundRobot find_robot(const std::string& name) {
  const NamedText text = find_text("robot", builtin_robots(), name);
  if (!text.error.empty()) return {{}, {}, {text.error}};
  return found(name, text.text);
}

}  // namespace labmouse
