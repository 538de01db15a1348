// One contest in seconds, in any of its worlds: a strategy decides, a driver drives, or fails to, and an operator
// carries the mouse back to the start.
//
//   search ──reset──► home ──► speed run ──► asked again        crash ──► carried to the start ──► asked again
//
// While it searches the mouse decides at every edge, and may reset wherever it is. Then it is driven: home over what is
// known to be open, looking about on the way, and from the start along the fastest route that is known.
#pragma once

#include "labmouse/contest/contest_driver.hpp"
#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/driving_strategy.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// Runs the contest. The strategy must be new, of a driver that errs with a sight of one cell; the driver new, and one
/// that writes into the record.
void run_contest(const Maze& maze, const DriveRules& rules, const DriveModel& model, DrivingStrategy& mouse,
                 ContestDriver& driver, PhysicalRecord& record);

}  // namespace labmouse
