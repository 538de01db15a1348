// The worlds in which robots drive, by the rules of real contests: without errors (seconds), with a simulated body and
// controller (physical), and with random failures in place of these (the failure model).
#pragma once

#include <memory>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/lab/drive/drive_figures.hpp"
#include "labmouse/lab/failure_rates/failure_file.hpp"
#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// Contests of this robot (without an error) under these rules. Scores are in seconds.
std::shared_ptr<const World> seconds_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model);

/// The same with errors: under these conditions the robot slips, detects walls wrongly and crashes. It must be able to
/// drive in the physical world.
std::shared_ptr<const World> physical_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model,
                                            const PhysicalConditions& conditions);

/// The same with failure rates, which were counted of that robot, in place of a body and a controller.
std::shared_ptr<const World> failure_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model,
                                           const PhysicalConditions& conditions, const FailureFile& failure_rates);

}  // namespace labmouse
