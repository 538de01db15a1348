// One contest, frame by frame: `Play` in apps/web/page/src/core/types.ts.
#pragma once

#include <nlohmann/json.hpp>

#include "labmouse/lab/record_file.hpp"

namespace labmouse {

/// Of a record that has a maze and agrees with it. Costs of candidates become steps, grounds become words.
nlohmann::ordered_json play_json(const RecordFile& file);

}  // namespace labmouse
