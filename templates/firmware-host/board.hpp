// Which pin is wired to which part of the robot: the UKMARSbot of boards/ukmarsbot.toml, which has comments. Numbers of
// pins are Arduino's.
#pragma once

#include <vector>

#include "arduino/Arduino.h"

/// A wheel: its motor and its encoder.
struct HostWheel {
  int pwm, direction, level_ahead;
  int clock, b;  ///< pins of A xor B, and of B
  bool a_leads;  ///< whether edges of A come first while it turns ahead
};

/// An infrared sensor, in the order of the robot file.
struct HostInfrared {
  int pin, emitter;
  double scale, ambient;
};

inline const HostWheel host_wheels[2] = {{9, 7, HIGH, 2, 4, true}, {10, 8, LOW, 3, 5, false}};
inline const std::vector<HostInfrared> host_infrared = {{A0, 12, 0.28, 20}, {A1, 12, 0.28, 20}, {A2, 12, 0.28, 20}};

inline constexpr int host_supply = 5000;                           ///< mV
inline constexpr int host_battery = A7, host_battery_divider = 2;
inline constexpr int host_button = A6, host_released = 3226, host_pressed = 5000;  ///< pin, mV
inline constexpr int host_press_at = 500, host_press_hold = 200;                   ///< ms
