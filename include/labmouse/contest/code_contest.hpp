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

/// The briefing of a program in such a contest; maze, rules and model must outlive it.
ControllerBriefing controller_briefing(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                                       const PhysicalConditions& conditions, std::uint64_t seed);

/// Runs the contest, as drive_physically() does for a strategy. The program must be new and briefed as above.
PhysicalRecord drive_by_code(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                             const PhysicalConditions& conditions, std::uint64_t seed, ControllerCode& code);

}  // namespace labmouse
