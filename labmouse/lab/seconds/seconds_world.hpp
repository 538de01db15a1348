// The world in seconds: a robot with curves and diagonals, by the rules of real contests, on one clock.
#pragma once

#include <memory>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/seconds/seconds_figures.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// Contests of this robot (without an error) under these rules. Scores are seconds; of what it holds, Held::run is a
/// DriveRecord.
std::shared_ptr<const World> seconds_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model);

/// The record of a contest as a file.
DriveRecordFile drive_record_file_of(const Contestant& mouse, const NamedMaze& maze, const DriveRules& rules,
                                     std::shared_ptr<const DriveModel> model, std::uint64_t seed, DriveRecord record);

}  // namespace labmouse
