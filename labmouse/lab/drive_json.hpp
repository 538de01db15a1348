// Places and times of the world in seconds as JSON.
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "labmouse/mouse/drive/tables.hpp"

namespace labmouse {

/// [x, y, heading, place]: [0, 3, "north", "edge"].
inline nlohmann::ordered_json node_json(const DriveNode& node) {
  return {node.cell.x, node.cell.y, name_of(node.heading), name_of(node.place)};
}

/// Microseconds, null for no_time.
inline nlohmann::ordered_json time_json(DriveTime time) {
  return time < no_time ? nlohmann::ordered_json(time) : nlohmann::ordered_json(nullptr);
}

/// Sixteen hexadecimal digits.
inline std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

}  // namespace labmouse
