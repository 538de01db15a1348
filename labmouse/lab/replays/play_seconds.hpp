// A contest in seconds as a play: `Play` with `drive` in apps/web/page/src/core/types.ts.
#pragma once

#include <vector>

#include "labmouse/lab/pictures/drive_path.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// Of a record that agrees with its maze.
Json play_json(const DriveRecordFile& contest);

/// A path alone: `DrivePath` there.
Json path_json(const std::vector<DrivePathPoint>& points);

}  // namespace labmouse
