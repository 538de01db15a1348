// Whether a route of a record could have been driven, and in that time.
#pragma once

#include <string>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

/// Drives the route again from rest at the start, through walls known to be open: where its pieces lead, and their
/// times, by the tables of the robot. Returns where it first disagrees, or nothing. Any route will do, even one from
/// outside of the maze.
std::string check_route(const DriveRoute& route, Pose start, Size size, const WallSet& open, const CellSet& goals,
                        const DriveModel& model);

}  // namespace labmouse
