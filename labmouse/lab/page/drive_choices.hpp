// The built-in robots and rules for contests in seconds, as the page lists them.
#pragma once

#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// For the call `about`: all robots with their cell widths in mm, all rules with their sources.
Json page_robots_json();
Json page_rules_json();
/// The keys of robot files, in the order of robot_keys().
Json page_robot_keys_json();

}  // namespace labmouse
