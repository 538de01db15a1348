// One key of robot files: its range and its conditions.
#pragma once

#include <span>
#include <string_view>

namespace labmouse {

/// A key of a robot file. `with` gives the files that may have it. `curves`: those in which turns follow from limits;
/// `turns`: those with the times of turns. `search_speed` and `search_times`: those with the speed or with the times of
/// a search. `body`: those that describe the hardware.
struct RobotKey {
  enum class With : unsigned char { always, curves, turns, search_speed, search_times, body };
  enum class Kind : unsigned char { number, whole, number_or_false, yes_or_no, choice };
  /// A sensor that a robot may lack; then it needs none of its keys. `infrared`: any infrared sensor.
  enum class Sensor : unsigned char { none, gyro, accelerometer, side, front, infrared, ranger };

  std::string_view name;     ///< section and name: "straight.speed"
  std::string_view meaning;  ///< as in docs/reference/files.md
  std::string_view unit;
  double low = 0.0;
  double high = 0.0;
  With with = With::always;
  bool needed = true;
  Kind kind = Kind::number;
  bool of_diagonals = false;
  std::string_view former = {};  ///< its name in earlier versions, which is read, too
  Sensor sensor = Sensor::none;
  std::span<const std::string_view> choices =
      {};  ///< the texts that it may have; the first one is the default of files
};

}  // namespace labmouse
