// How hard a mouse corrects itself.
#pragma once

#include "labmouse/hardware/hardware.hpp"

namespace labmouse {

/// Of one axis: duty for an error of a mm/s or a rad/s, and for a mm or a rad of its sum.
struct AxisGains {
  double proportional = 0.0;
  double integral = 0.0;
};

/// Errors die away as those of an oscillator of that frequency and damping.
struct TrackerGains {
  double frequency = 12.0;  ///< rad/s
  double damping = 0.8;
  double slow_speed = 0.0;      ///< mm/s; below it the law for slow mice is used
  double slow_stiffness = 0.0;  ///< 1/mm²
  double slow_damping = 0.8;
};

struct Gains {
  AxisGains drive, turn;
  /// What the controller takes for the motors, for what it need not correct.
  MotorAxis drive_model, turn_model;
  TrackerGains tracker;
  double speed_filter = 0.2;  ///< how much of a moment's speed by the encoders is believed
};

/// Ours, for some hardware in cells of that many mm.
Gains gains_for(const Hardware& hardware, double cell);

}  // namespace labmouse
