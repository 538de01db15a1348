// What is to be said below the leaderboard of a race of programs written for mms.
#pragma once

#include <string>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

std::string mms_notes(const Race& race);
/// How runs ended otherwise than by exit code 0, and lines that mms would not answer.
std::string mms_remarks(const Race& race);

}  // namespace labmouse
