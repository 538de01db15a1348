// What a program that drives a mouse itself is told before the contest, in the lines of its protocol.
#pragma once

#include <string>

#include "labmouse/contest/controller_code.hpp"

namespace labmouse {

/// From the greeting to `begin`: the maze's size, start and goals, the rules with times in ms, and what the robot is
/// built of under the keys of robot files.
std::string controller_lines(const ControllerBriefing& briefing);

}  // namespace labmouse
