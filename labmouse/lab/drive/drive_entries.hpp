// Entries, in the list of all worlds, of the worlds in which robots drive.
#pragma once

#include <string>

#include "labmouse/lab/failure_rates/failure_file.hpp"
#include "labmouse/lab/races/world_entry.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

extern const WorldEntry seconds_entry;
extern const WorldEntry physical_entry;
extern const WorldEntry failures_entry;

/// Why these failure rates cannot be used for that robot under that noise; the message names the options to change.
/// Empty if they can be used.
std::string why_not_failures(const DriveModel& model, double variation, const FailureFile& failure_rates);

}  // namespace labmouse
