// A robot with numbers that vary: all the robots that one file stands for.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "labmouse/lab/robots/robot_file.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// A number of robot files, by the name of its key ("curve.lateral_acceleration"), in the key's unit.
struct RobotNumber {
  std::string_view key;
  double value = 0.0;
};

/// The robots that differ from one file in some of its numbers.
class RobotFamily {
 public:
  /// Of the text of a robot file, which may be wrong.
  RobotFamily(std::string_view text, std::string_view name);

  /// The one with these numbers in place of its own, or what is wrong with it.
  RobotResult with(std::span<const RobotNumber> numbers) const;

 private:
  std::string name_;
  Json values_;
};

/// Why a number of that key cannot be varied, as a line without an end; empty where it can: the key of a number that is
/// no whole one.
std::string why_not_varied(std::string_view key);

}  // namespace labmouse
