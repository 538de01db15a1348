// What is to be said below the leaderboard of a race, in lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// All of it: what the world has to say, how mice failed, what was left out of the means, and whether it was stopped.
std::string notes_of(const Race& race);

/// What the score is, and what a failed contest counts, in a line.
std::string score_note(const World& world);
/// The same for comparisons of mice, in which a failed contest always counts the limit score.
std::string limit_note(const World& world);

/// What external mice could do to the machine that they ran on, in lines; empty without such mice.
std::string sandbox_note(const std::vector<Contestant>& mice);

}  // namespace labmouse
