// One contest of a mouse that may err: in the physical world, where a simulated controller drives a simulated robot; or
// in the failure model, where errors are drawn at random. The protocol is that of contest/drive_contest.
//
// A strategy sees corridors of one cell, made of what the controller's evidence is rather for. By the map of the
// conditions the first reading of a wall stays for ever, as in most mice, and what speaks against it later is counted;
// or readings are weighed, walls turn over, and a strategy that sees no way any more looks again.
#pragma once

#include <cstdint>
#include <string>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/driving_strategy.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

struct FailureRates;

/// Raised where the same contest comes to another end: records of other editions can be shown, but not driven again.
inline constexpr int physical_edition = 2, failures_edition = 1;

/// Runs the contest, in a maze up to 32×32, with a robot that has limits and hardware. The strategy must be new and
/// briefed as by brief(), with a sight of one cell. All chance comes from the seed. Parts of the controller that are
/// somebody else's must be new, too; what they say is not part of the record, which can be shown and not be driven
/// again.
PhysicalRecord drive_physically(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                                const PhysicalConditions& conditions, std::uint64_t seed, DrivingStrategy& mouse,
                                const ControllerParts& parts = {});

/// The same in the failure model, and fast: localization errors, wall detection errors and crashes are drawn at the
/// rates of `failure rates`, which were counted in the physical world, with the random draws that the seed has there. A
/// localization error lasts from manoeuvre to manoeuvre, and the severity of the draws lasts for the contest: a mouse
/// with weak motors fails again. Of the conditions it uses noise, pace, map and handling.
PhysicalRecord drive_with_failures(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                                   const PhysicalConditions& conditions, const FailureRates& failure_rates,
                                   std::uint64_t seed, DrivingStrategy& mouse);

/// Whether the robot can drive there: why not, in a sentence about it; empty where it can.
std::string why_not_physical(const DriveModel& model);

}  // namespace labmouse
