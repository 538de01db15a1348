// One contest in seconds in which nothing goes wrong: a mouse searches, drives home and runs, on one clock. The
// protocol is that of contest/drive_contest, for all worlds in seconds.
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

/// Runs the contest, in a maze up to 32×32. The strategy must be new and briefed as above. A move through a wall that
/// it has not seen to be open, a reset before a goal was entered, and an action that is none of a search end the
/// contest as a forfeit, lost. After a run a strategy that has no more to do forfeits as finished: that ends the
/// contest and is none.
DriveRecord drive(const Maze& maze, const DriveRules& rules, const DriveModel& model, DrivingStrategy& mouse);

}  // namespace labmouse
