// The lists of a play: what was in each frame, and what each step did. Frame 0 is before the first step, frame i after
// step i; the reading of a step is taken in the frame before it.
#pragma once

#include <string>

#include "labmouse/lab/records/record_file.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// Adds `clock`, `x`, `y`, `heading`, `run`, and the frames `goal_frame` and `reset_frame`.
void add_frames(const RecordFile& file, Json& play);

/// Adds `action`, `blocked`, `left`, `ahead`, `right`, `entered`, and `known`.
void add_steps(const RecordFile& file, Json& play);

/// An action in words: "right, 3", "ahead 2", "back 1", "reset", "forfeit: no route".
std::string short_words(const Action& action);

}  // namespace labmouse
