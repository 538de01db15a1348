// The fastest route of a maze as JSON.
#pragma once

#include <string>

#include "labmouse/lab/routes/route_report.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// The JSON of one maze in `labmouse route --format json`; times in microseconds.
Json route_json(const RouteReport& report, const std::string& maze, const DriveModel& model);

}  // namespace labmouse
