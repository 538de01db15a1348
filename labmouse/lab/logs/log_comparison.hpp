// A log beside a robot that does the same: how far they differ, and where they part.
//
// Where the log has duties, the robot's motors get the same; they are made as unequal as those of the mouse, for no way
// stays straight under the duties that unequal motors need. Where it has none, the robot is driven after the speed and
// yaw speed that the log's mouse was to have, or else had, by the pilot's control of these two.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/logs/log_file.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// By ticks; one of them is empty where the log does not have it.
struct ComparedCurve {
  std::vector<double> log, robot;
  std::optional<std::size_t> parts;  ///< the tick at which they part, where they do
};

struct LogComparison {
  ComparedCurve speed, yaw, way, turn;  ///< mm/s, rad/s, mm, rad to the left
  bool by_duties = false;
  double stronger = 0.0;  ///< by how much the right motor was made stronger than the left one, as a share
  std::string error;      ///< why nothing was compared
};

/// Curves part where they differ, in the mean of some ticks about, by more than a twentieth of the log's peak and by
/// more than shaking and encoders make.
inline constexpr double parting_share = 0.05;

/// Drives the robot, which must have hardware, without noise and on an open floor. The log must begin at rest.
LogComparison compare_log(const Log& log, const Robot& robot);

/// A line for each curve: how far it differs, and when it parts; and of the first that does, where the mouse was.
std::string table_of(const LogComparison& comparison, std::string_view log_name, std::string_view robot_name);

/// Both curves of each, one above the other, as one self-contained SVG picture.
std::string picture_of(const LogComparison& comparison, std::string_view log_name, std::string_view robot_name);

}  // namespace labmouse
