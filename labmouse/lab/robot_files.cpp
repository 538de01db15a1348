#include "labmouse/lab/robot_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/builtin_robots.hpp"
#include "labmouse/lab/files.hpp"
#include "labmouse/lab/maze_files.hpp"
#include "labmouse/lab/printable.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {
namespace {

FoundRobot failure(std::string error) { return {{}, {}, {std::move(error)}}; }

FoundRobot found(const std::string& name, std::string_view text) {
  RobotResult read = read_robot(text, name);
  if (read.robot) return {std::move(*read.robot), std::move(read.model), {}};
  FoundRobot none;
  for (const Problem& problem : read.problems) none.errors.push_back(describe(name, problem));
  return none;
}

FoundRobot no_such_robot(const std::string& name) {
  std::vector<std::string_view> names;
  for (const BuiltinRobot& robot : builtin_robots()) names.push_back(robot.name);
  const auto near = nearest_name(name, names);
  return failure(fmt::format("error: unknown robot '{}'; {}", shown(name),
                             near.empty() ? fmt::format("there are {}, and files with a slash or .toml in their name",
                                                        fmt::join(names, ", "))
                                          : fmt::format("did you mean '{}'?", near)));
}

}  // namespace

FoundRobot find_robot(const std::string& name) {
  for (const BuiltinRobot& robot : builtin_robots())
    if (robot.name == name) return found(name, robot.text);
  if (name.find('/') == std::string::npos && !name.ends_with(".toml")) return no_such_robot(name);
  const FileContent file = read_file(name);
  if (!file.error.empty()) return failure(fmt::format("{}: error: {}", shown(name), file.error));
  return found(name, file.content);
}

}  // namespace labmouse
