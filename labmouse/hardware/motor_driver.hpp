// What the driver makes of a duty for the motor of one wheel, and the duty for what it should make.
#pragma once

#include <algorithm>
#include <cmath>

#include "labmouse/hardware/hardware.hpp"

namespace labmouse {

/// The two wheels, as indices of Motors::strength.
enum Wheel : std::size_t { left_wheel, right_wheel };

/// The duty at which the motor of a wheel neither drives it nor brakes it, but for friction.
/// @param speed mm/s of the wheels' mean, along the mouse.
/// @param turning rad/s of the mouse to the left.
inline double idle_duty(const Motors& motors, Wheel wheel, double speed, double turning) {
  const double own = turning / (2.0 * motors.turn.gain);
  return speed / motors.drive.gain + (wheel == left_wheel ? -own : own);
}

/// The duty of a driver that brakes and loses nothing which has the same effect as this one, at the full voltage.
/// @param duty from -1 to 1.
/// @param strength of the motor, as a share of the nominal one.
/// @param voltage as a share of the full one.
/// @param idle as by idle_duty().
inline double braked_duty(const Motors& motors, double duty, double strength, double voltage, double idle) {
  const double given = duty - std::clamp(duty, -motors.dead_time, motors.dead_time);
  if (motors.coast <= 0.0) return given * strength * voltage;
  // While the driver is off, the motor is idle.
  return idle + std::abs(given) * (std::copysign(strength * voltage, given) - idle);
}

/// The inverse of braked_duty(): the duty that has the effect of `braked`. It can be beyond full duty.
/// @param full the full voltage as a multiple of the present one.
inline double duty_for(const Motors& motors, double braked, double strength, double full, double idle) {
  double given = full * braked / strength;
  if (motors.coast > 0.0) {
    const double beyond = braked - idle, most = strength / full;
    // Close to the highest speed no duty gives more.
    constexpr double least = 0.05;
    given = beyond / std::max(least, beyond < 0.0 ? most + idle : most - idle);
  }
  return given == 0.0 ? 0.0 : given + std::copysign(motors.dead_time, given);
}

}  // namespace labmouse
