// The robots and the rules for contests in seconds that the page brings along.
#pragma once

#include <optional>
#include <string_view>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// Those of that name; nothing where there are none. A page reads no files.
std::optional<DriveModel> page_robot(std::string_view name);
std::optional<DriveRules> page_rules(std::string_view name);

/// All of them, for `about`: robots with their cells, rules with their sources.
Json page_robots_json();
Json page_rules_json();

}  // namespace labmouse
