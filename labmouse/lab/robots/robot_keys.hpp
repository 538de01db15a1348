// All keys of robot files: their ranges, and which of them go together.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "labmouse/lab/robots/robot_key.hpp"

namespace labmouse {

/// All keys, in the order of docs/reference/files.md; those of hardware_keys() come last.
std::span<const RobotKey> robot_keys();
/// The key of that name, or null.
const RobotKey* find_robot_key(std::string_view name);
/// The key of that name in earlier versions, or null.
const RobotKey* find_former_key(std::string_view name);
/// Whether a section describes the hardware. A file has all of these sections or none.
bool is_body_section(std::string_view section);
/// The lists of sensors in robot files.
inline constexpr std::string_view infrared_list = "infrared", ranger_list = "ranger";

/// The first key that a sentence names, by its name or in words ("search speed"); empty for none.
std::string_view key_in(std::string_view sentence);

/// The range of a key in words: "50 to 20000 mm/s".
std::string range_of(const RobotKey& key);

/// The form of a robot file. `turns`: it gives the times of turns, not the limits of curves. `search_times`: it gives
/// the times of a search, not its speed. `diagonals`: the robot drives diagonals. `body`: it describes the hardware.
/// `infrared_list`, `ranger_list`: its sensors are listed one by one.
struct RobotForms {
  bool turns = false;
  bool search_times = false;
  bool diagonals = true;
  bool body = false;
  bool infrared_list = false;
  bool ranger_list = false;

  bool has(const RobotKey& key) const;
};

/// Why a key has no effect in these forms, to be written behind the name of the key.
std::string_view why_not(const RobotKey& key, const RobotForms& forms);

}  // namespace labmouse
