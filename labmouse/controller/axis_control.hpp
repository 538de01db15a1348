// Computes the duty cycles of the motors from the commanded speed and turn rate.
//
// Method: feedforward from a motor model, plus a proportional and an integral term.
#pragma once

#include "labmouse/controller/gains.hpp"
#include "labmouse/controller/tracker.hpp"
#include "labmouse/hardware/sense.hpp"

namespace labmouse {

class AxisControl {
 public:
  AxisControl(const Gains& gains, const Motors& motors) : gains_(gains), motors_(motors) {}

  void reset() { drive_sum_ = turn_sum_ = 0.0; }
  /// Returns the duties for one tick, from the measured speed (mm/s), turn rate (rad/s) and battery voltage.
  Drive control(const Command& command, double speed, double turning, double volts);

 private:
  Gains gains_;
  Motors motors_;
  double drive_sum_ = 0.0, turn_sum_ = 0.0;  ///< integrals of the speed and turn-rate errors, mm and rad
};

}  // namespace labmouse
