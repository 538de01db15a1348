// Checks that a recorded route can be driven, and in the recorded time.
#pragma once

#include <string>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

/// Drives the route from rest at the start and compares its places and times with the robot's tables. All passed walls
/// must be in `open`. Any route is safe to pass, even one that leaves the maze. Returns the first difference, or an
/// empty text.
std::string check_route(const DriveRoute& route, Pose start, Size size, const WallSet& open, const CellSet& goals,
                        const DriveModel& model);

}  // namespace labmouse
