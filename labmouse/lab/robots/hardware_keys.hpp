// The keys of robot files that describe the hardware, and the number that each of them sets.
#pragma once

#include <span>

#include "labmouse/hardware/hardware.hpp"
#include "labmouse/lab/robots/robot_key.hpp"

namespace labmouse {

/// Hardware as the keys of robot files describe it. Pairs of infrared sensors that look aside and ahead, one ToF sensor
/// that looks ahead, and the numbers that infrared sensors have in common stand beside its lists of sensors.
struct HardwareNumbers {
  Hardware hardware;
  Beam side, front;   ///< the left ones; the right ones mirror them
  Infrared infrared;  ///< without its beam
  Ranger ranger;
};

/// A key of a robot file that sets a number of the hardware.
struct HardwareKey {
  RobotKey key;
  /// The number of the key. One unit of it is `unit` units of the file.
  double& (*number)(HardwareNumbers&);
  double unit = 1.0;
  bool added_later = false;  ///< JSON leaves it out where it has its default, so that older records stay unchanged
};

/// All of them, in the order of docs/reference/files.md.
std::span<const HardwareKey> hardware_keys();

/// A key of the tables [[infrared]] or [[ranger]], which list sensors one by one.
template <class Sensor>
struct SensorKey {
  RobotKey key;  ///< its name is that within the table
  double& (*number)(Sensor&);
};

std::span<const SensorKey<Infrared>> infrared_keys();
std::span<const SensorKey<Ranger>> ranger_keys();

/// Which of the sensors that HardwareNumbers describes a robot has.
struct PlainSensors {
  bool side = false, front = false, ranger = false;
};

/// The hardware with the sensors that those numbers describe.
Hardware hardware_of(const HardwareNumbers& numbers, PlainSensors which);

/// Hardware in the terms of robot files.
struct HardwareTerms {
  HardwareNumbers numbers;
  PlainSensors plain;
  bool lists = false;  ///< its infrared and ToF sensors are others, and stand in lists

  /// Whether a file of this robot has that key.
  bool has(const RobotKey& key) const;
};
HardwareTerms terms_of(const Hardware& hardware);

}  // namespace labmouse
