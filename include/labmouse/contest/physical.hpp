// Contests with errors: in the physical world, where a simulated controller drives a simulated robot, or in the failure
// model, where errors are drawn at random. The protocol is that of contest/drive_contest.
//
// A strategy sees one cell far, and gets the more likely state of each wall. The map of the conditions decides on
// contradicting readings: either the first reading of a wall stays, as in most mice, and contradictions are only
// counted; or readings are combined, walls can change, and a strategy without a route looks again.
#pragma once

#include <cstdint>
#include <string>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/controller/parts.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/driving_strategy.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

struct FailureRates;

/// Increased when the same contest gets another result: records of other editions can be shown, but not re-run.
inline constexpr int physical_edition = 4, failures_edition = 4;

/// Runs the contest.
/// @param maze up to 32×32 cells.
/// @param rules what counts, and the time limit.
/// @param model a robot that has limits and hardware; why_not_physical() must be empty.
/// @param conditions errors, controller and map; where its `log` points gets every tick.
/// @param seed all chance comes from it.
/// @param mouse new, and briefed as by brief(), with a sight of one cell.
/// @param parts external parts of the controller, new. Their output is not recorded, so such a record can be shown but
///   not re-run.
/// @return the record of the contest in seconds with what was true and what the controller estimated.
PhysicalRecord drive_physically(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                                const PhysicalConditions& conditions, std::uint64_t seed, DrivingStrategy& mouse,
                                const ControllerParts& parts = {});

/// Runs the contest in the failure model, which is fast. Localization errors, wall detection errors and crashes are
/// drawn at `failure_rates`, and the seed gives the same robot sample as in the physical world. A localization error
/// lasts from manoeuvre to manoeuvre, and the robot sample for the contest: a mouse with weak motors fails again.
/// @param maze up to 32×32 cells.
/// @param rules what counts, and the time limit.
/// @param model a robot that has limits and hardware; why_not_physical() must be empty.
/// @param conditions it uses their noise, variation, pace, map and handling.
/// @param failure_rates measured in the physical world.
/// @param seed all chance comes from it.
/// @param mouse new, and briefed as by brief(), with a sight of one cell.
/// @return as drive_physically().
PhysicalRecord drive_with_failures(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                                   const PhysicalConditions& conditions, const FailureRates& failure_rates,
                                   std::uint64_t seed, DrivingStrategy& mouse);

/// Why a robot cannot drive in the physical world: it lacks hardware, has too many sensors, or has turns that are only
/// times.
/// @param model the robot.
/// @return a clause for the user, such as "its turns are times, ..."; empty if it can.
std::string why_not_physical(const DriveModel& model);

}  // namespace labmouse
