// The keys of robot files: what each may be, and which go together.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace labmouse {

/// A robot has curves by its limits or the times of its turns; and for its search a speed or times.
struct RobotKey {
  enum class With : unsigned char { always, curves, turns, search_speed, search_times };
  enum class Kind : unsigned char { number, whole, number_or_false, yes_or_no, end };

  std::string_view name;     ///< with its section: "straight.speed"
  std::string_view meaning;  ///< as in docs/robots.md
  std::string_view unit;
  double low = 0.0;
  double high = 0.0;
  With with = With::always;
  bool needed = true;
  Kind kind = Kind::number;
  bool of_diagonals = false;
};

/// All of them, in the order of docs/robots.md.
std::span<const RobotKey> robot_keys();

/// Of which key a sentence about a robot speaks first, by its name or in words ("search speed"); empty for none.
std::string_view key_in(std::string_view sentence);

/// "50 to 20000 mm/s"
std::string range_of(const RobotKey& key);

/// What is said behind that of a value that is in range once it is taken for one in metres, seconds or degrees; empty
/// otherwise.
std::string hint_of(const RobotKey& key, double value);

/// Which of the two ways a file goes, three times.
struct RobotForms {
  bool turns = false;
  bool search_times = false;
  bool diagonals = true;

  bool has(const RobotKey& key) const;
};

/// Behind the name of a key that the forms do not have.
std::string_view why_not(const RobotKey& key, const RobotForms& forms);

}  // namespace labmouse
