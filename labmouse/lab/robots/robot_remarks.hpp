// What is allowed in a robot, and likely to be a mistake.
#pragma once

#include <string>
#include <vector>

#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// Numbers that look as if they were in another unit: degrees for radians, metres for millimetres. A line each, without
/// the robot's name; none for a robot that is as mice are.
std::vector<std::string> robot_remarks(const Robot& robot, const DriveModel& model);

}  // namespace labmouse
