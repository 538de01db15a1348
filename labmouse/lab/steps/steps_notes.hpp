// What is to be said below the leaderboard of a race in steps.
#pragma once

#include <string>

#include "labmouse/contest/rules.hpp"
#include "labmouse/lab/races/race.hpp"

namespace labmouse {

std::string steps_notes(const Race& race, const Rules& rules);
/// Below the failures: steps that were not performed as asked, and mazes that are not as capstone robots expect them.
std::string steps_remarks(const Race& race);

}  // namespace labmouse
