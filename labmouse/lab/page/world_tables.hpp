// Tables by which the page shows results of each world.
#pragma once

#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// For each group of worlds with equal tables: units and fields of scores, and columns of leaderboards. It is stored as
/// apps/web/page/src/core/worlds.json, because the page shows results before the WebAssembly module has started.
Json world_tables_json();

}  // namespace labmouse
