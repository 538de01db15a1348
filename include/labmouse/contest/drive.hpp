// One contest in seconds without errors: a mouse searches, drives home and makes speed runs, on one clock. The protocol
// is that of contest/drive_contest.
#pragma once

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/driving_strategy.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// The briefing of a mouse in a contest in seconds. The model must outlive the mouse, and have no error.
Briefing brief(const Maze& maze, const DriveRules& rules, const DriveModel& model, std::uint64_t seed);

/// Runs the contest, in a maze up to 32×32. The strategy must be new and briefed as above. The contest ends as a
/// forfeit (`lost`) on a move through a wall not seen open, a reset before a goal was entered, or an action that is
/// not a search move. A strategy that has no more to do after a run forfeits as `finished`: that ends the contest, and
/// does not count as a forfeit.
DriveRecord drive(const Maze& maze, const DriveRules& rules, const DriveModel& model, DrivingStrategy& mouse);

}  // namespace labmouse
