// A contest in seconds as a play: `Play` with `drive` in apps/web/page/src/core/types.ts.
#pragma once

#include <nlohmann/json.hpp>

#include "labmouse/lab/records/drive_record_file.hpp"

namespace labmouse {

/// Of a record that agrees with its maze.
nlohmann::ordered_json play_json(const DriveRecordFile& contest);

}  // namespace labmouse
