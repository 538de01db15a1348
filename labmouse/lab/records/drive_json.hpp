// JSON shared by records and reports of the world in seconds. Times are whole microseconds.
#pragma once

#include <fmt/format.h>

#include <string>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/optional_json.hpp"
#include "labmouse/mouse/robot/tables.hpp"

namespace labmouse {

/// A node of a route as [x, y, heading, place], such as [0, 3, "north", "edge"].
inline Json node_json(const DriveNode& node) {
  return {node.cell.x, node.cell.y, name_of(node.heading), name_of(node.place)};
}

/// The time in microseconds; null for no_time.
inline Json time_json(DriveTime time) { return time < no_time ? Json(time) : Json(nullptr); }

/// Sixteen hexadecimal digits.
inline std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

Json rules_json(const DriveRules& rules);

/// The best run under the rules with the parts of its score; runs are numbered from 1. Null where no run has a score.
Json score_json(const DriveScore& score);
Json dead_ends_json(const DeadEndCount& count);

}  // namespace labmouse
