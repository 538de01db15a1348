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

/// The briefing of a mouse in a contest in seconds: as in the world of steps, and the robot and its time.
/// @param maze the briefing has its size, start and goals, but no walls.
/// @param rules the briefing has its time limit, runs and bonus.
/// @param model the robot; it must outlive the mouse, and have no error.
/// @param seed for the random numbers of the strategy; the world has none.
Briefing brief(const Maze& maze, const DriveRules& rules, const DriveModel& model, std::uint64_t seed);

/// Runs the contest. It ends as a forfeit (`lost`) on a move through a wall not seen open, a reset before a goal was
/// entered, or an action that is not a search move. A strategy that has no more to do after a run forfeits as
/// `finished`: that ends the contest, and does not count as a forfeit.
/// @param maze up to 32×32 cells.
/// @param rules what counts, and the time limit.
/// @param model the robot, without error.
/// @param mouse new, and briefed as by brief().
/// @return all moves, walls and runs, in microseconds since the first start.
DriveRecord drive(const Maze& maze, const DriveRules& rules, const DriveModel& model, DrivingStrategy& mouse);

}  // namespace labmouse
