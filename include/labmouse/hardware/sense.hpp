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

/// What the counter of an encoder shows of a number.
/// @param count the number of counts, modulo 2^32.
/// @param bits width of the counter, whole, 8 to 32.
/// @return the lowest `bits` bits of the number, with a sign: from -2^(bits - 1) to 2^(bits - 1) - 1.
constexpr std::int32_t wrapped(std::uint32_t count, double bits) {
  const int unused = 32 - static_cast<int>(bits);
  return static_cast<std::int32_t>(count << unused) >> unused;
}

/// What a ToF sensor reads.
struct RangeSense {
  std::uint16_t distance = 0;  ///< mm along its beam to what it looks at; 0 where nothing is seen
  bool is_new = false;         ///< whether that was read at this tick, not at an earlier one

  friend bool operator==(const RangeSense&, const RangeSense&) = default;
};

/// What the hardware reads at a tick. Sensors that the robot lacks read 0.
struct Sense {
  std::uint32_t tick = 0;                              ///< ms since the mouse was switched on
  std::array<std::int32_t, 2> counts{};                ///< of the encoders since then, left and right; they wrap
  std::int16_t gyro = 0;                               ///< units of Sensors::gyro_step, to the left
  std::array<std::int16_t, 2> acceleration{};          ///< units of Sensors::acceleration_step, ahead and to the left
  std::array<std::int16_t, most_infrared> infrared{};  ///< counts; Variation::ambient says what ambient light adds
  std::array<RangeSense, most_rangers> ranges{};
  std::uint16_t millivolts = 0;                          ///< of the battery, under its present load
  std::uint8_t infrared_sensors = 0, range_sensors = 0;  ///< how many the robot has

  /// The readings of the infrared sensors that the robot has, in the order of Sensors::infrared; part of this object.
  std::span<const std::int16_t> all_infrared() const { return std::span(infrared).first(infrared_sensors); }
  /// The readings of the ToF sensors that the robot has, in the order of Sensors::rangers; part of this object.
  std::span<const RangeSense> all_ranges() const { return std::span(ranges).first(range_sensors); }

  friend bool operator==(const Sense&, const Sense&) = default;
};

/// The command to the motors until the next tick.
struct Drive {
  float left = 0.0F;   ///< duty of the left motor, cut to -1 to 1
  float right = 0.0F;  ///< duty of the right motor, cut to -1 to 1

  friend bool operator==(const Drive&, const Drive&) = default;
};

}  // namespace labmouse
