// Reference position and motion of a mouse at one moment.
#pragma once

#include "labmouse/functions/angles.hpp"
#include "labmouse/functions/position.hpp"

namespace labmouse {

/// Angles and turn rates are positive to the left; `ahead` is the direction of motion.
struct Target {
  Position position;
  Direction ahead;
  double speed = 0.0;     ///< mm/s, below 0 backwards
  double speeding = 0.0;  ///< mm/s²
  double turning = 0.0;   ///< rad/s
  double twisting = 0.0;  ///< rad/s²
};

}  // namespace labmouse
