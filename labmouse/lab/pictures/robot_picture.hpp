// A robot as a picture: each of its turns among its walls.
#pragma once

#include <string>

#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// An SVG file: the six turns, each with the walls that it needs open and those that may stand, the path and its
/// figures.
std::string draw_robot(const Robot& robot, const DriveModel& model);

}  // namespace labmouse
