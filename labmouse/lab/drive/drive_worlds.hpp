// The worlds in which robots drive, by the rules of real contests: without errors, with a body and a controller, and
// with what these do wrong by dice.
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

/// Contests of this robot (without an error) under these rules. Scores are seconds; of what any of these worlds holds,
/// Held::run is a DriveRecord.
std::shared_ptr<const World> seconds_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model);

/// The same of a robot that can drive there, which slips, wrong walls and crashes under these conditions.
std::shared_ptr<const World> physical_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model,
                                            const PhysicalConditions& conditions);

/// The same with failure rates, which were counted of that robot, in place of a body and a controller.
std::shared_ptr<const World> failure_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model,
                                           const PhysicalConditions& conditions, const FailureFile& failure_rates);

}  // namespace labmouse
