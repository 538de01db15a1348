// How the page shows a race in each world.
#pragma once

#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// All worlds, those with the same table together: the units and fields of their scores, and the columns of their
/// leaderboards. The page has it as a file,
/// apps/web/page/src/core/worlds.json, because it shows results before its core has started.
Json world_tables_json();

}  // namespace labmouse
