// Replays records by running their contests again: those of the physical world and the failure model, and time trials.
#pragma once

#include <string>

#include "labmouse/lab/records/drive_record_file.hpp"

namespace labmouse {

/// Re-runs the contest with the recorded decisions in place of a strategy, and compares the result with the record. The
/// mouse's name and its number of plans are not checked. Returns the first difference, or an empty text.
std::string replay_physically(const DriveRecordFile& file);

/// Re-runs a time trial in the world in seconds, in which the mouse decides nothing, and compares the result and the
/// score with the record. Returns the first difference, or an empty text.
std::string replay_laps(const DriveRecordFile& file);

/// Re-runs the contest of a record with which replay_physically() found no difference, with one trace point every
/// `trace_every` ticks. A log gets all ticks.
PhysicalRecord drive_again(const DriveRecordFile& file, int trace_every, std::vector<LoggedTick>* log = nullptr);

}  // namespace labmouse
