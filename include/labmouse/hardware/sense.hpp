// The interface between a mouse's hardware and its controller: raw sensor readings one way, motor duties the other,
// once a millisecond.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "labmouse/hardware/hardware.hpp"

namespace labmouse {

/// One step of body and controller, in seconds.
inline constexpr double tick_seconds = 0.001;

/// What a counter of an encoder with so many bits, 8 to 32, shows of a number: it wraps.
constexpr std::int32_t wrapped(std::uint32_t count, double bits) {
  const int unused = 32 - static_cast<int>(bits);
  return static_cast<std::int32_t>(count << unused) >> unused;
}

/// What a ToF sensor reads.
struct RangeSense {
  std::uint16_t distance = 0;  ///< mm to what it looks at; 0 where nothing is seen
  bool is_new = false;         ///< whether that was read just now

  friend bool operator==(const RangeSense&, const RangeSense&) = default;
};

/// What the hardware reads at a tick. Sensors that the robot lacks read 0.
struct Sense {
  std::uint32_t tick = 0;                              ///< ms since the mouse was switched on
  std::array<std::int32_t, 2> counts{};                ///< of the encoders since then, left and right
  std::int16_t gyro = 0;                               ///< units, to the left
  std::array<std::int16_t, 2> acceleration{};          ///< units, ahead and to the left
  std::array<std::int16_t, most_infrared> infrared{};  ///< counts, without ambient light
  std::array<RangeSense, most_rangers> ranges{};
  std::uint16_t millivolts = 0;                          ///< of the battery
  std::uint8_t infrared_sensors = 0, range_sensors = 0;  ///< how many the robot has

  std::span<const std::int16_t> all_infrared() const { return std::span(infrared).first(infrared_sensors); }
  std::span<const RangeSense> all_ranges() const { return std::span(ranges).first(range_sensors); }

  friend bool operator==(const Sense&, const Sense&) = default;
};

/// The command to the motors until the next tick.
struct Drive {
  float left = 0.0F;  ///< duty, cut to -1 to 1
  float right = 0.0F;

  friend bool operator==(const Drive&, const Drive&) = default;
};

}  // namespace labmouse
