#include "labmouse/controller/gains.hpp"

#include <algorithm>

namespace labmouse {
namespace {

/// Gains with which the error decays at that natural frequency (rad/s), with little overshoot.
AxisGains axis_gains(const MotorAxis& axis, double frequency) {
  constexpr double damping = 0.9;
  return {std::max(0.0, 2.0 * damping * frequency * axis.time - 1.0) / axis.gain,
          frequency * frequency * axis.time / axis.gain};
}

}  // namespace

Gains gains_for(const Hardware& hardware, double cell) {
  Gains gains;
  gains.drive_model = hardware.motors.drive;
  gains.turn_model = hardware.motors.turn;
  gains.drive = axis_gains(hardware.motors.drive, 40.0);
  gains.turn = axis_gains(hardware.motors.turn, 50.0);
  gains.seconds = gains.tracker.seconds = hardware.motors.period * tick_seconds;
  gains.tracker.slow_speed = cell;
  gains.tracker.slow_stiffness = 8.0 / (cell * cell);
  return gains;
}

Gains gains_each_tick(const Hardware& hardware, double cell) {
  Gains gains = gains_for(hardware, cell);
  gains.seconds = tick_seconds;
  return gains;
}

}  // namespace labmouse
