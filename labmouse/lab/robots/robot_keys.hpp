// The keys of robot files: what each may be, and which go together.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "labmouse/lab/robots/robot_key.hpp"

namespace labmouse {

/// All of them, in the order of docs/reference/files.md, those of hardware_keys() last.
std::span<const RobotKey> robot_keys();
/// The sections that say what a robot is built of: a file has all of them or none.
bool is_body_section(std::string_view section);

/// Of which key a sentence about a robot speaks first, by its name or in words ("search speed"); empty for none.
std::string_view key_in(std::string_view sentence);

/// "50 to 20000 mm/s"
std::string range_of(const RobotKey& key);

/// What is said behind that of a value that is in range once it is taken for one in metres, seconds or degrees; empty
/// otherwise.
std::string hint_of(const RobotKey& key, double value);

/// Which of the two ways a file goes, four times.
struct RobotForms {
  bool turns = false;
  bool search_times = false;
  bool diagonals = true;
  bool body = false;

  bool has(const RobotKey& key) const;
};

/// Behind the name of a key that the forms do not have.
std::string_view why_not(const RobotKey& key, const RobotForms& forms);

}  // namespace labmouse
