// The fields of a line of a record in seconds, read strictly.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/grid/wall_set.hpp"
#include "labmouse/lab/text/json_fields.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

/// Microseconds that a record can hold.
inline constexpr std::int64_t longest_time = std::int64_t{1} << 50U;

// All of these give the fields, or the outer ones, what is wrong; `size` is that of the maze.

/// [x, y, heading] and [x, y, heading, place].
Pose pose_in(JsonFields& fields, const char* key, Size size);
DriveNode node_in(JsonFields& fields, const char* key, Size size);
/// Inner walls, as rows of hexadecimal digits.
WallSet walls_in(const ReadJson& json, const char* key, Size size, JsonFields& outer);
/// S3, D4, L45 and so on, from the segment's first node, which is there already; a turn has its speed beside it.
void read_piece(const ReadJson& json, JsonFields& fields, const DriveTables& tables, DriveSegment& segment);
void read_drive_rules_json(const ReadJson& json, DriveRules& rules, JsonFields& outer);

}  // namespace labmouse
