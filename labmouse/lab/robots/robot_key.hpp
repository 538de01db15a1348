// One key of robot files: what it may be, and with what it goes together.
#pragma once

#include <string_view>

namespace labmouse {

/// A robot has curves by its limits or the times of its turns; for its search a speed or times; and a body or none.
struct RobotKey {
  enum class With : unsigned char { always, curves, turns, search_speed, search_times, body };
  enum class Kind : unsigned char { number, whole, number_or_false, yes_or_no, end };

  std::string_view name;     ///< with its section: "straight.speed"
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
