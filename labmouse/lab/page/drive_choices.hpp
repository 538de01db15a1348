// The robots and the rules for contests in seconds that the page brings along.
#pragma once

#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// All of them, for `about`: robots with their cells, rules with their sources.
Json page_robots_json();
Json page_rules_json();
/// The keys of robot files, in the order of their forms.
Json page_robot_keys_json();

}  // namespace labmouse
