// What happened in a contest in seconds, in words and in order: what the mouse set out to do and why, which walls it
// looked at twice, and what ended its runs.
#pragma once

#include <string>

#include "labmouse/lab/records/drive_record_file.hpp"

namespace labmouse {

/// A line for each event, with its time on the maze's clock in seconds.
std::string story_of(const DriveRecordFile& file);

}  // namespace labmouse
