// The paths of a contest in the physical world, by the trace of its record: of the true mouse, and of the one that it
// thinks it is.
#pragma once

#include <cstddef>
#include <vector>

#include "labmouse/lab/pictures/drive_path.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"

namespace labmouse {

/// Of one run of a record of the physical world; empty without a trace.
std::vector<DrivePathPoint> true_path(const DriveRecordFile& file, std::size_t run);
std::vector<DrivePathPoint> believed_path(const DriveRecordFile& file, std::size_t run);

/// Where it touched something.
DrivePathPoint touched_at(const DriveRecordFile& file, const WallTouch& touch);

}  // namespace labmouse
