// One contest, frame by frame: `Play` in apps/web/page/src/core/types.ts.
#pragma once

#include "labmouse/lab/records/mms_record_file.hpp"
#include "labmouse/lab/records/record_file.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// Of a record that has a maze and agrees with it. Costs of candidates are converted to steps, and
/// reasons of decisions to text.
Json play_json(const RecordFile& file);

/// Of a record of mms that agrees with its maze.
Json play_json(const MmsRecordFile& file);

}  // namespace labmouse
