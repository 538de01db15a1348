// The robots of one entry in which one value of the robot file differs.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/worlds/entering.hpp"

namespace labmouse {

/// A world for each value of one key of a robot file; they differ in nothing else. Or an error.
struct RobotVariants {
  std::string robot;    ///< the name of the robot that they are made from
  std::string key;      ///< such as "straight.acceleration"
  std::string meaning;  ///< of the key, with its unit
  std::vector<std::string> values;
  std::vector<std::shared_ptr<const World>> worlds;  ///< as many as values, in the same order
  std::vector<std::string> remarks;                  ///< values that are likely to be mistakes, a line each
  std::string error;                                 ///< for the user, in one line
};

/// Makes the worlds. Equal values in different spelling count once. An error names the key and the value: one that
/// robot files refuse, a key that changes nothing in this world, and a world whose robot cannot be changed.
RobotVariants robot_variants(const Entry& entry, std::string_view key, std::span<const std::string> values);

}  // namespace labmouse
