// Where a mouse should be at a moment, and how it should move there.
#pragma once

#include "labmouse/functions/angles.hpp"
#include "labmouse/functions/position.hpp"

namespace labmouse {

/// Angles and turning are to the left; `ahead` is where it should go.
struct Target {
  Position position;
  Direction ahead;
  double speed = 0.0;     ///< mm/s, below 0 backwards
  double speeding = 0.0;  ///< mm/s²
  double turning = 0.0;   ///< rad/s
  double twisting = 0.0;  ///< rad/s²
};

}  // namespace labmouse
