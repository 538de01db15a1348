// What is to be said below the leaderboard of a race.
#pragma once

#include <string>

#include "labmouse/lab/races/tournament.hpp"

namespace labmouse {

/// What the score means, what was left out of the means, how mice failed, and what else a reader has to know; in lines.
std::string notes_of(const Race& race);

}  // namespace labmouse
