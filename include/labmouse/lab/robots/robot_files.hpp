// Finds robots: built-in ones and those of files.
#pragma once

#include <string>
#include <vector>

#include "labmouse/lab/robots/robot_file.hpp"

namespace labmouse {

/// A robot with the model computed from it, or why there is none.
struct FoundRobot {
  Robot robot;
  DriveModel model;
  std::vector<std::string> errors;   ///< one line for each problem, such as describe() gives; empty if it was found
  std::vector<std::string> remarks;  ///< likely mistakes, one line each, which begins with the robot's name
};

/// Finds a robot, and makes its model.
/// @param name of a built-in robot, or the path of a file: a name with a slash or the ending `.toml`, or `-` for
///   standard input. After a line feed, the text of the robot may follow, which then replaces the file. The robot gets
///   this name, up to the line feed.
/// @return the robot; or errors if there is none of that name, or if its file cannot be read or is wrong.
FoundRobot find_robot(const std::string& name);

}  // namespace labmouse
