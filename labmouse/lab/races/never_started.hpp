// External mice that did not race at all.
#pragma once

#include <string>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// A line for each external mouse that started in no contest: its program could not be run, or was given up before its
/// first word. Such a race says nothing of the external mouse. Empty where all external mice raced.
std::string never_started_lines(const Race& race);

}  // namespace labmouse
