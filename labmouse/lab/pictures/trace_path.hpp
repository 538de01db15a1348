// True and estimated paths of a contest in the physical world, from the trace of its record.
#pragma once

#include <cstddef>
#include <vector>

#include "labmouse/lab/pictures/drive_path.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"

namespace labmouse {

/// The crash that ended that run; null where the record has none.
const WallTouch* crash_in(const DriveRecordFile& file, const DriveRun& run);

/// The trace of one run. A crash between two points of the trace adds a last point, with the estimate and the readings
/// of the point before.
std::vector<TracePoint> trace_of(const DriveRecordFile& file, const DriveRun& run);

/// The true and the estimated path of one run; empty without a trace.
std::vector<DrivePathPoint> true_path(const DriveRecordFile& file, std::size_t run);
std::vector<DrivePathPoint> believed_path(const DriveRecordFile& file, std::size_t run);

/// The point where the mouse touched something.
DrivePathPoint touched_at(const DriveRecordFile& file, const WallTouch& touch);

}  // namespace labmouse
