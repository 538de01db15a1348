// One contest of a mouse that may err: a mind decides, a driver drives, or fails to, and an operator carries the mouse
// back to the start.
//
//   search ──reset──► home ──► fast run ──► asked again        crash ──► carried to the start ──► asked again
#pragma once

#include "labmouse/contest/contest_driver.hpp"
#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/strategy.hpp"

namespace labmouse {

/// Holds the contest. The strategy must be new, with a sight of one cell; the driver new, and one that writes into the
/// record. Of the conditions it takes what carrying a mouse to the start takes, and the usual pace.
void hold_contest(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                  const PhysicalConditions& conditions, Strategy& mouse, ContestDriver& driver, PhysicalRecord& record);

}  // namespace labmouse
