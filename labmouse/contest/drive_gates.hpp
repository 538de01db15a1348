// When a fast run passes the gates: where its path leaves the start cell, and where it enters a goal.
#pragma once

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// Sets the gates and the centre of a run by its route. A run that begins in a goal passes all of them as it begins.
void set_gates(DriveRun& run, const Maze& maze, const DriveModel& model);

}  // namespace labmouse
