// Strict readers of the fields in a line of a record in seconds.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/grid/wall_set.hpp"
#include "labmouse/lab/text/json_fields.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

/// The longest time in a record, in microseconds.
inline constexpr std::int64_t longest_time = std::int64_t{1} << 50U;

// These functions report errors through `fields` or `outer`. `size` is the size of the maze.

/// [x, y, heading] and [x, y, heading, place].
Pose pose_in(JsonFields& fields, const char* key, Size size);
DriveNode node_in(JsonFields& fields, const char* key, Size size);
/// Inner walls, given as rows of hexadecimal digits.
WallSet walls_in(const ReadJson& json, const char* key, Size size, JsonFields& outer);
/// Reads a piece such as S3, D4 or L45 into `segment`, whose first node must be set. A turn also gives its speed.
void read_piece(const ReadJson& json, JsonFields& fields, const DriveTables& tables, DriveSegment& segment);
void read_drive_rules_json(const ReadJson& json, DriveRules& rules, JsonFields& outer);

}  // namespace labmouse
