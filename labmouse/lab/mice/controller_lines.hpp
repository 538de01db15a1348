// The briefing of a controller that is a program, in the lines of its protocol.
#pragma once

#include <string>

#include "labmouse/contest/controller_code.hpp"

namespace labmouse {

/// From the greeting to `begin`: the maze's size, start and goals, the rules with times in ms, and what the robot is
/// built of under the keys of robot files.
std::string controller_lines(const ControllerBriefing& briefing);

}  // namespace labmouse
