// The briefing of an external controller program, in the lines of its protocol.
#pragma once

#include <string>

#include "labmouse/contest/controller_code.hpp"

namespace labmouse {

/// All lines from the greeting to `begin`: the maze's size, start and goals, the rules with times in ms, and the
/// robot's hardware under the keys of robot files.
std::string controller_lines(const ControllerBriefing& briefing);

}  // namespace labmouse
