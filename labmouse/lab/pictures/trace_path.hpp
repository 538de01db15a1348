// The paths of a contest in the physical world, by the trace of its record: of the true mouse, and of the one that it
// thinks it is.
#pragma once

#include <cstddef>
#include <vector>

#include "labmouse/lab/pictures/drive_path.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"

namespace labmouse {

/// The crash that ended that run; null where the record has none.
const WallTouch* crash_in(const DriveRecordFile& file, const DriveRun& run);

/// The trace of one run. It ends where the run crashed, also between two points of the record: there the mouse still
/// believes and reads what it did at the point before.
std::vector<TracePoint> trace_of(const DriveRecordFile& file, const DriveRun& run);

/// Of one run of a record of the physical world; empty without a trace.
std::vector<DrivePathPoint> true_path(const DriveRecordFile& file, std::size_t run);
std::vector<DrivePathPoint> believed_path(const DriveRecordFile& file, std::size_t run);

/// Where it touched something.
DrivePathPoint touched_at(const DriveRecordFile& file, const WallTouch& touch);

}  // namespace labmouse
