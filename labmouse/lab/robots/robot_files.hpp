// Robots from files, and those that the program brings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/robots/robot_family.hpp"
#include "labmouse/lab/robots/robot_file.hpp"

namespace labmouse {

/// A robot with all that follows from it, or why there is none: a line for each problem, as `describe` words them.
struct FoundRobot {
  Robot robot;
  DriveModel model;
  std::vector<std::string> errors;
  std::vector<std::string> remarks;  ///< on likely mistakes, a line each, with its name
};

/// The built-in robot of that name, or that of a file, whose name has a slash or ends in `.toml`. A robot's own name is
/// the one given here.
FoundRobot find_robot(const std::string& name);

/// The robots that differ from that one in some numbers, or why there are none. What is wrong with the file itself
/// shows with the first of them.
struct FoundFamily {
  std::optional<RobotFamily> family;
  std::string error;
};
FoundFamily find_robot_family(const std::string& name);

}  // namespace labmouse
