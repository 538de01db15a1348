// The protocol of a contest in seconds, for all its worlds: a strategy decides, a driver moves the mouse or fails, and
// an operator carries it back to the start.
//
//   search ──reset──► home ──► speed run ──► asked again        crash ──► carried to the start ──► asked again
//
// While it searches the mouse decides at every edge, and may reset wherever it is. Then it drives home over known open
// walls, with readings on the way, and from the start along the fastest known route.
//
// Where the rules count laps, there is no search: see contest/lap_contest.
#pragma once

#include "labmouse/contest/contest_driver.hpp"
#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/driving_strategy.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// Runs the contest. Strategy and driver must be new; the driver must write into `record`. With a driver that errs, the
/// strategy must have a sight of one cell.
void run_contest(const Maze& maze, const DriveRules& rules, const DriveModel& model, DrivingStrategy& mouse,
                 ContestDriver& driver, PhysicalRecord& record);

}  // namespace labmouse
