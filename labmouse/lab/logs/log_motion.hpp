// How a mouse moved by its log, in the ticks of a body.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "labmouse/hardware/hardware.hpp"
#include "labmouse/lab/logs/log_file.hpp"

namespace labmouse {

/// Ticks from `begin` to before `end`.
struct TickSpan {
  std::size_t begin = 0;
  std::size_t end = 0;

  std::size_t size() const { return end - begin; }
};

/// By ticks, a millisecond apart; what the log does not say is empty.
struct LogMotion {
  std::size_t ticks = 0;
  std::vector<double> left, right;  ///< what the motors got from each tick to the next, as shares of a full battery
  std::vector<double> way;          ///< mm of the middle of the axle, by the encoders
  std::vector<double> angle;        ///< rad to the left, by the gyro, or else by the encoders
  bool by_gyro = false;
  std::vector<TickSpan> rests;  ///< where the mouse stood, a tenth of a second or longer
};

/// The motion, or why there is none.
struct LogMotionResult {
  LogMotion motion;
  std::string error;
};

/// Takes millimetres for a count, track, and what the battery gives under load from the hardware. Between rows duties
/// stay, and all else goes on steadily. The gyro shows 0 in the mean of all rests.
LogMotionResult motion_of(const Log& log, const Hardware& hardware);

/// The change in a tick, in the mean of some ticks about each: mm/s of a way, rad/s of an angle.
std::vector<double> rates_of(const std::vector<double>& places, std::size_t about = 10);

}  // namespace labmouse
