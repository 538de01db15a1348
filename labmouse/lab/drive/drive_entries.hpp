// The worlds in which robots drive on the list of all worlds.
#pragma once

#include <string>

#include "labmouse/lab/failure_rates/failure_file.hpp"
#include "labmouse/lab/races/world_entry.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

extern const WorldEntry seconds_entry;
extern const WorldEntry physical_entry;
extern const WorldEntry failures_entry;

/// Why such failure rates say nothing of a robot under that noise, naming the options that chose them; empty where they
/// do.
std::string why_not_failures(const DriveModel& model, double noise, const FailureFile& failure_rates);

}  // namespace labmouse
