// One contest in the physical world of a mouse with an external controller, which is its whole program.
//
//   at rest in the start cell ──► run ──► in a goal ──► way home ──► at rest in the start cell
//                                  └── crash, or wants to be carried ──► carried to the start
//
// Runs begin and end by what can be observed from outside, as by gates and judges at a contest.
#pragma once

#include <cstdint>

#include "labmouse/contest/controller_code.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// The briefing of a program in such a contest.
/// @param maze the briefing has its size, start and goals, but no walls.
/// @param rules must outlive the program.
/// @param model must outlive the program.
/// @param conditions the briefing has their handling time, but not the amount of noise.
/// @param seed for random numbers of the program; another one than that of the contest, from which it could compute the
/// noise.
ControllerBriefing controller_briefing(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                                       const PhysicalConditions& conditions, std::uint64_t seed);

/// Runs the contest, as drive_physically() does for a strategy.
/// @param maze up to 32×32 cells.
/// @param rules what counts, and the time limit.
/// @param model a robot that has limits and hardware; why_not_physical() must be empty.
/// @param conditions errors and handling time; map and controller are the program's own.
/// @param seed all chance comes from it.
/// @param code new, and briefed as by controller_briefing().
/// @return the record, with the output of the program for every tick in `tape`, from which it can be re-run.
PhysicalRecord drive_by_code(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                             const PhysicalConditions& conditions, std::uint64_t seed, ControllerCode& code);

}  // namespace labmouse
