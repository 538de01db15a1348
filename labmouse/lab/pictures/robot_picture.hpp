// Draws the turns of a robot, each with the walls around it.
#pragma once

#include <string>

#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// An SVG file with up to six kinds of turns: walls that must be open, walls that may be closed, path, speeds, times
/// and lengths.
std::string draw_robot(const Robot& robot, const DriveModel& model);

}  // namespace labmouse
