// What a run and a race say of steps that were not performed as the mouse asked for them.
#pragma once

#include <string>

#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/records/record_file.hpp"

namespace labmouse {

/// An action in words: "turn -90, move +1".
std::string action_words(const Action& action);

/// A line for each kind of misstep of a contest, with the first such step; empty where there is none.
std::string misstep_lines(const RecordFile& file);

/// A line for each mouse of a race that has missteps, under a line that says what they are; empty where there is none.
std::string misstep_lines(const Race& race);

}  // namespace labmouse
