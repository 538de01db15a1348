// Guests that did not race at all.
#pragma once

#include <string>

#include "labmouse/lab/races/mms_race.hpp"
#include "labmouse/lab/races/tournament.hpp"

namespace labmouse {

/// A line for each guest that started in no contest: its program could not be run, or was given up before it greeted.
/// Such a race says nothing of the guest. Empty where all guests raced.
std::string never_started_lines(const Race& race);

/// The same for programs written for mms: not one line came from them.
std::string never_started_lines(const MmsRace& race);

}  // namespace labmouse
