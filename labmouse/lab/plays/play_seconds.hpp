// A contest in seconds as a play: `Play` with `drive` in apps/web/page/src/core/types.ts.
#pragma once

#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// Of a record that agrees with its maze.
Json play_json(const DriveRecordFile& contest);

}  // namespace labmouse
