// Speeds as JSON, for the page and for `labmouse bench --format json`.
#pragma once

#include "labmouse/lab/bench/distance_speed.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// For each side, an object of `rows`, `portable_rows`, `queue` and `plain` in nanoseconds.
Json distance_json(const DistanceSpeeds& speeds);

}  // namespace labmouse
