// The keys of robot files that describe the hardware, and the field of `Hardware` that each of them sets.
#pragma once

#include <span>

#include "labmouse/hardware/hardware.hpp"
#include "labmouse/lab/robots/robot_key.hpp"

namespace labmouse {

/// A key of a robot file that sets a field of `Hardware`.
struct HardwareKey {
  RobotKey key;
  /// The field for the key. One unit of the field is `unit` units of the file.
  double& (*number)(Hardware&);
  double unit = 1.0;
};

/// All of them, in the order of docs/reference/files.md.
std::span<const HardwareKey> hardware_keys();

}  // namespace labmouse
