// Simulates a robot without noise on an open floor, with given PWM duties or target speeds.
#pragma once

#include <vector>

#include "labmouse/body/plant.hpp"
#include "labmouse/controller/axis_control.hpp"

namespace labmouse {

class OpenFloor {
 public:
  /// Begins at rest.
  /// @param hardware Must outlive this object. @param cell Width of a cell in mm.
  /// @param stronger Strength of the right motor minus that of the left one, as a share of their mean. The mean is that
  /// of the hardware.
  OpenFloor(const Hardware& hardware, double cell, double stronger);

  /// Simulates one tick with these duties.
  void push(const Drive& drive);
  /// Simulates one tick with the duties of the controller for these speeds.
  void follow(const Command& command);

  /// At the start and after each tick: path length in mm, and heading in rad, counterclockwise from the start.
  const std::vector<double>& ways() const { return ways_; }
  const std::vector<double>& angles() const { return angles_; }

 private:
  void note();

  const Hardware& hardware_;
  Maze maze_;
  Field field_;
  RobotSample robot_sample_;
  Plant plant_;
  AxisControl control_;
  std::vector<double> ways_, angles_;
  double way_ = 0.0;
};

}  // namespace labmouse
