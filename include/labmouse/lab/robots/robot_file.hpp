// Reads robot files, described in docs/reference/files.md: TOML with lengths in mm, limits in mm/s, mm/s² and rad/s²,
// times in ms.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/maze/formats/format.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// A robot with the model computed from it, or what is wrong with its file: exactly one of the two is there.
struct RobotResult {
  std::optional<Robot> robot;
  DriveModel model;               ///< of the robot; empty if there is none
  std::vector<Problem> problems;  ///< empty if there is a robot
};

/// Where the text of a robot comes from. Records have older defaults than files: two speeds of each turn, and runs that
/// end at any speed.
enum class RobotText : unsigned char { file, recorded };
/// Number of speeds of each turn of a recorded robot that does not state it.
inline constexpr int recorded_speeds = 2;

/// Reads a robot, and makes its model.
/// @param text TOML of at most 64 KiB; more is a problem.
/// @param name the name that the robot gets.
/// @param kind which defaults the text has.
/// @return the robot with its model, or the problems with their lines. An error of the model is a problem of the whole
///   file.
RobotResult read_robot(std::string_view text, std::string_view name, RobotText kind = RobotText::file);

}  // namespace labmouse
