// The physical world: a robot that slips, misreads and crashes, by the rules of real contests.
#pragma once

#include <memory>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/lab/physical/physical_figures.hpp"
#include "labmouse/lab/races/race.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// Contests of this robot (without an error, and one that can drive there) under these rules and conditions. Scores are
/// seconds; of what it holds, Held::run is a PhysicalRecord.
std::shared_ptr<const World> physical_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model,
                                            const PhysicalConditions& conditions);

}  // namespace labmouse
