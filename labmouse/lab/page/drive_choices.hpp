// The robots and the rules for contests in seconds that the page brings along.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// The robot in a field of a request, or why there is none.
struct PageRobot {
  DriveModel model;
  std::string error;
};

/// A name; a name with the text of a robot file below it; or a robot as it stands in records and results. A page reads
/// no files.
PageRobot page_robot(const ReadJson& robot);
/// Those of that name; nothing where there are none.
std::optional<DriveRules> page_rules(std::string_view name);

/// All of them, for `about`: robots with their cells, rules with their sources.
Json page_robots_json();
Json page_rules_json();
/// The keys of robot files, in the order of their forms.
Json page_robot_keys_json();

}  // namespace labmouse
