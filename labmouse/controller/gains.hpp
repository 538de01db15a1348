// Gains of the control loops.
#pragma once

#include "labmouse/hardware/hardware.hpp"
#include "labmouse/hardware/sense.hpp"

namespace labmouse {

/// Gains of one axis: duty per mm/s or rad/s of error, and per mm or rad of its integral.
struct AxisGains {
  double proportional = 0.0;
  double integral = 0.0;
};

/// Tracking errors decay like an oscillator of this frequency and damping.
struct TrackerGains {
  double frequency = 12.0;  ///< rad/s
  double damping = 0.8;
  double slow_speed = 0.0;      ///< mm/s; below it the law for slow mice is used
  double slow_stiffness = 0.0;  ///< 1/mm²
  double slow_damping = 0.8;
  double seconds = tick_seconds;  ///< from one call to the next
};

struct Gains {
  AxisGains drive, turn;
  /// Motor models for the feedforward.
  MotorAxis drive_model, turn_model;
  TrackerGains tracker;
  double seconds = tick_seconds;  ///< from one call to the next
  double speed_filter = 0.2;      ///< weight of a call's encoder speed in the estimate, 0 to 1
};

/// The built-in gains for a robot's hardware and cells of `cell` mm.
Gains gains_for(const Hardware& hardware, double cell);
/// The same for loops that run at each tick, whatever the robot's own period is.
Gains gains_each_tick(const Hardware& hardware, double cell);

}  // namespace labmouse
