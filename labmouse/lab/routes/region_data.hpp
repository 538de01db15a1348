// JSON of the regions in which one route stays the fastest.
#pragma once

#include <string>

#include "labmouse/lab/routes/route_regions.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// The output of `labmouse route --vary --format json`; times in microseconds.
Json regions_json(const RouteRegions& regions, const RegionOrder& order, const std::string& maze,
                  const std::string& robot);

}  // namespace labmouse
