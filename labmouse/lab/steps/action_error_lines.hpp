// What a race says of steps that were not performed as the mouse asked for them.
#pragma once

#include <string>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// A line for each mouse of a race that has action errors, under a line that says what they are; empty where there is
/// none.
std::string action_error_lines(const Race& race);

}  // namespace labmouse
