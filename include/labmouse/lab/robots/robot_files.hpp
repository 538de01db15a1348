// Finds robots: built-in ones and those of files.
#pragma once

#include <string>
#include <vector>

#include "labmouse/lab/robots/robot_file.hpp"

namespace labmouse {

/// A robot with the model computed from it, or why there is none: a line for each problem, as `describe` formats it.
struct FoundRobot {
  Robot robot;
  DriveModel model;
  std::vector<std::string> errors;
  std::vector<std::string> remarks;  ///< likely mistakes, one line each, which begins with the robot's name
};

/// Finds a robot by the name of a built-in one, or by the path of a file (a name with a slash or the ending `.toml`).
/// It gets the name given here.
FoundRobot find_robot(const std::string& name);

}  // namespace labmouse
