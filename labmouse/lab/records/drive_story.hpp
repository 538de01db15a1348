// The events of a contest in seconds, in words and in order: why each run began, which walls it saw again and with what
// result, and how the runs ended.
#pragma once

#include <string>

#include "labmouse/lab/records/drive_record_file.hpp"

namespace labmouse {

/// A line for each event, with its time on the maze's clock in seconds.
std::string story_of(const DriveRecordFile& file);

}  // namespace labmouse
