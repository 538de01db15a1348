// The robots that differ from one robot file in some numbers.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "labmouse/lab/robots/robot_file.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// A number of a robot file: the name of its key, such as "curve.lateral_acceleration", and its value in the key's
/// unit.
struct RobotNumber {
  std::string_view key;
  double value = 0.0;
};

/// Makes robots from one robot file with some numbers replaced.
class RobotFamily {
 public:
  /// Takes the text of a robot file, which may be wrong; with() reports its problems.
  RobotFamily(std::string_view text, std::string_view name);

  /// The robot with these numbers in place of its own, or what is wrong with it.
  RobotResult with(std::span<const RobotNumber> numbers) const;

  /// The text of the file with the value of one key replaced: a number, true, false or a word. `diagonals` = false also
  /// removes the keys of diagonals, which would have no effect. The robot may be invalid; read_robot() tells.
  std::string text_with(std::string_view key, std::string_view value) const;

 private:
  std::string name_;
  Json values_;
};

/// The family of robots that one file gives, or why there is none. Errors in the file itself are reported by
/// RobotFamily::with().
struct FoundFamily {
  std::optional<RobotFamily> family;
  std::string error;
};
/// Finds it by the name of a built-in robot, or by the path of a file, as find_robot() does.
FoundFamily find_robot_family(const std::string& name);

/// Why there is no such key in robot files, in a line without a line feed, with the key that was probably meant; empty
/// where there is one.
std::string why_no_key(std::string_view key);

/// Why the number of that key cannot be varied, in a line without a line feed; empty where it can. Only numbers that
/// are not whole can.
std::string why_not_varied(std::string_view key);

}  // namespace labmouse
