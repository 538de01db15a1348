// A contest in the terminal: step by step, or its end.
#pragma once

#include <string>

#include "labmouse/lab/records/record_file.hpp"

namespace labmouse::cli {

/// Draws every step with what the mouse knows by then, and how it ended: as frames of an animation on a terminal, one
/// below the other elsewhere. `delay` is the time a frame stays, in milliseconds. Throws UsageError where the terminal
/// is too small.
void watch(const RecordFile& file, int delay);

/// The maze with the speed run, a line on what the exploration saw, what the mouse counted, steps that were not
/// performed as it asked, and how the contest went.
std::string summary_of(const RecordFile& file);

}  // namespace labmouse::cli
