// Records of the physical world, driven again.
#pragma once

#include <string>

#include "labmouse/lab/records/drive_record_file.hpp"

namespace labmouse {

/// Runs the contest again, with the decisions of the record in place of a strategy, and compares all that was written;
/// where the record first disagrees, or nothing. Who drove, and how often it planned, is taken over unchecked.
std::string replay_physically(const DriveRecordFile& file);

/// The contest of a record that replay_physically() agrees with as it is run again, with a point of the trace each so
/// many ticks.
PhysicalRecord drive_again(const DriveRecordFile& file, int trace_every);

}  // namespace labmouse
