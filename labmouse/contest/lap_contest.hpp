// The protocol of a time trial, for all worlds in seconds: laps of the outermost ring of the maze, which the mouse
// knows. It decides only on its pace, before each start. After a crash it is carried to the start and begins again.
#pragma once

#include "labmouse/contest/contest_driver.hpp"
#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/driving_strategy.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// Runs the contest until all laps are completed or the time is over. Strategy and driver must be new; the driver must
/// write into `record`. Without a route (see lap_route()) the contest ends without a run.
void run_laps(const Maze& maze, const DriveRules& rules, const DriveModel& model, DrivingStrategy& mouse,
              ContestDriver& driver, PhysicalRecord& record);

}  // namespace labmouse
