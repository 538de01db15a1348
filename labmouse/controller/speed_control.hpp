// Drives at the speed and turn rate that a program asks for: the inner loop of a controller that does not send duties.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "labmouse/controller/axis_control.hpp"
#include "labmouse/hardware/hardware.hpp"
#include "labmouse/hardware/sense.hpp"

namespace labmouse {

/// Measures the speed by the encoders and the turn rate by the gyro, or by the encoders where there is none, and
/// controls both. It does not know the bias of the gyro.
class SpeedControl {
 public:
  /// @param hardware nominal.
  /// @param cell side of a cell in mm.
  SpeedControl(const Hardware& hardware, double cell);

  /// The mouse was put down, at rest.
  void rest();

  /// Called each tick.
  /// @param speed wanted, in mm/s.
  /// @param turning wanted turn rate, in rad/s to the left.
  /// @return the duties until the next tick.
  Drive control(double speed, double turning, const Sense& sense);

 private:
  void measure(const Sense& sense);

  Hardware hardware_;
  Gains gains_;
  AxisControl axes_;
  std::optional<std::array<std::int32_t, 2>> counts_;  ///< of the tick before
  double speed_ = 0.0, turning_ = 0.0;                 ///< measured
};

}  // namespace labmouse
