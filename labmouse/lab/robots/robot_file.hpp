// Robots as files, described in docs/reference/files.md: TOML with lengths in mm, limits in mm/s, mm/s² and rad/s²,
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

/// A robot with all that follows from it, or what is wrong with its file: exactly one of the two is there.
struct RobotResult {
  std::optional<Robot> robot;
  DriveModel model;
  std::vector<Problem> problems;
};

/// Where the text of a robot is from. In records, what does not stand there is as it was before there was a choice: two
/// speeds of each turn, and runs that end at any speed.
enum class RobotText : unsigned char { file, recorded };
inline constexpr int recorded_speeds = 2;

/// Reads a robot of at most 64 KiB, which will have that name, and makes its model. What the model refuses is a problem
/// of the file as a whole.
RobotResult read_robot(std::string_view text, std::string_view name, RobotText kind = RobotText::file);

}  // namespace labmouse
