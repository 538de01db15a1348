// From how fast a mouse has to drive and turn to the duties of its motors.
//
// Method: what a motor model says is needed, and what a proportional and an integral term add.
#pragma once

#include "labmouse/controller/gains.hpp"
#include "labmouse/controller/tracker.hpp"
#include "labmouse/hardware/sense.hpp"

namespace labmouse {

class AxisControl {
 public:
  AxisControl(const Gains& gains, const Motors& motors) : gains_(gains), motors_(motors) {}

  void reset() { drive_sum_ = turn_sum_ = 0.0; }
  /// One tick: the duties for a command, where the mouse drives and turns as fast as that, by a battery of so many
  /// volts.
  Drive control(const Command& command, double speed, double turning, double volts);

 private:
  Gains gains_;
  Motors motors_;
  double drive_sum_ = 0.0, turn_sum_ = 0.0;  ///< of errors, mm and rad
};

}  // namespace labmouse
