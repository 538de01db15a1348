// The interface between a mouse's hardware and its controller: raw sensor readings one way, motor duties the other,
// once a millisecond.
#pragma once

#include <array>
#include <cstdint>

#include "labmouse/hardware/hardware.hpp"

namespace labmouse {

/// One step of body and controller, in seconds.
inline constexpr double tick_seconds = 0.001;

/// What the hardware reads at a tick.
struct Sense {
  std::uint32_t tick = 0;                           ///< ms since the mouse was switched on
  std::array<std::int32_t, 2> counts{};             ///< of the encoders since then, left and right
  std::int16_t gyro = 0;                            ///< units, to the left
  std::array<std::int16_t, 2> acceleration{};       ///< units, ahead and to the left
  std::array<std::int16_t, beam_count> infrared{};  ///< counts, without ambient light
  std::uint16_t range = 0;                          ///< mm to what is ahead; 0 where nothing is seen
  bool range_new = false;                           ///< whether `range` was read just now
  std::uint16_t millivolts = 0;                     ///< of the battery

  friend bool operator==(const Sense&, const Sense&) = default;
};

/// The command to the motors until the next tick.
struct Drive {
  float left = 0.0F;  ///< duty, cut to -1 to 1
  float right = 0.0F;

  friend bool operator==(const Drive&, const Drive&) = default;
};

}  // namespace labmouse
