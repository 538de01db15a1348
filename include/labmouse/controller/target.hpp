// Reference position and motion of a mouse at one moment.
#pragma once

#include "labmouse/functions/angles.hpp"
#include "labmouse/functions/position.hpp"

namespace labmouse {

/// Where a mouse should be at one moment, and how it should move there. Angles and turn rates are positive to the left.
struct Target {
  Position position;      ///< of the middle of the axle, mm
  Direction ahead;        ///< direction in which it should move if `speed` is above 0: angle from east to the left
  double speed = 0.0;     ///< mm/s, below 0 backwards
  double speeding = 0.0;  ///< mm/s²
  double turning = 0.0;   ///< rad/s
  double twisting = 0.0;  ///< rad/s²
};

}  // namespace labmouse
