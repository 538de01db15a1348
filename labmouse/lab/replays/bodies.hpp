// The true and the estimated mouse of a contest in the physical world as the page draws them, with the readings and
// the wall contacts of the true one.
#pragma once

#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// Of a record with a trace, point by point of the true mouse's path, run after run: `DriveBodies` in
/// apps/web/page/src/core/types.ts.
Json bodies_json(const DriveRecordFile& contest);

}  // namespace labmouse
