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
  DriveModel model;
  std::vector<Problem> problems;
};

/// Where the text of a robot comes from. Records have older defaults than files: two speeds of each turn, and runs that
/// end at any speed.
enum class RobotText : unsigned char { file, recorded };
inline constexpr int recorded_speeds = 2;

/// Reads a robot from a text of at most 64 KiB, gives it the name `name`, and makes its model. Errors of the model are
/// problems of the file as a whole.
RobotResult read_robot(std::string_view text, std::string_view name, RobotText kind = RobotText::file);

}  // namespace labmouse
