// The physical world: a robot that slips, misreads and crashes, by the rules of real contests; and the fallible one, in
// which it does so by dice.
#pragma once

#include <memory>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/lab/hazards/hazard_file.hpp"
#include "labmouse/lab/physical/physical_figures.hpp"
#include "labmouse/lab/races/race.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// Contests of this robot (without an error, and one that can drive there) under these rules and conditions. Scores are
/// seconds; of what it holds, Held::run is a PhysicalRecord.
std::shared_ptr<const World> physical_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model,
                                            const PhysicalConditions& conditions);

/// The same with hazards, which were counted of that robot, in place of a body and a pilot.
std::shared_ptr<const World> fallible_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model,
                                            const PhysicalConditions& conditions, const HazardFile& hazards);

}  // namespace labmouse
