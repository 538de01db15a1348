// Which route wins for which robot, as JSON.
#pragma once

#include <string>

#include "labmouse/lab/routes/route_regions.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// What `labmouse route --vary --format json` says, times in microseconds.
Json regions_json(const RouteRegions& regions, const RegionOrder& order, const std::string& maze,
                  const std::string& robot);

}  // namespace labmouse
