// Finds values of a robot that are allowed but likely to be mistakes.
#pragma once

#include <string>
#include <vector>

#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// Numbers that look as if they had another unit: degrees for radians, metres for millimetres. One line each, without
/// the robot's name.
std::vector<std::string> robot_remarks(const Robot& robot, const DriveModel& model);

}  // namespace labmouse
