// The keys of robot files that say what a mouse is built of, and the number that each of them is.
#pragma once

#include <span>

#include "labmouse/hardware/hardware.hpp"
#include "labmouse/lab/robots/robot_key.hpp"

namespace labmouse {

struct HardwareKey {
  RobotKey key;
  /// The number in some hardware, in its own unit; and how many of the file's are one of its own.
  double& (*number)(Hardware&);
  double unit = 1.0;
};

/// All of them, in the order of docs/reference/files.md.
std::span<const HardwareKey> hardware_keys();

}  // namespace labmouse
