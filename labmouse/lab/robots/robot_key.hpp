// One key of robot files: its range and its conditions.
#pragma once

#include <string_view>

namespace labmouse {

/// A key of a robot file. `With` says which robots have it: those whose curves follow from limits (curves) or have
/// given times (turns); whose search has a speed or given times; or that have a body.
struct RobotKey {
  enum class With : unsigned char { always, curves, turns, search_speed, search_times, body };
  enum class Kind : unsigned char { number, whole, number_or_false, yes_or_no, end };

  std::string_view name;     ///< section and name: "straight.speed"
  std::string_view meaning;  ///< as in docs/reference/files.md
  std::string_view unit;
  double low = 0.0;
  double high = 0.0;
  With with = With::always;
  bool needed = true;
  Kind kind = Kind::number;
  bool of_diagonals = false;
};

}  // namespace labmouse
