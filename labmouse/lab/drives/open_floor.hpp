// A robot on an open floor, without noise: what it does under given duties, or after given speeds.
#pragma once

#include <vector>

#include "labmouse/body/plant.hpp"
#include "labmouse/controller/axis_control.hpp"

namespace labmouse {

class OpenFloor {
 public:
  /// At rest. The right motor is stronger than the left one by that share; both are as strong as the hardware's in the
  /// mean. The hardware must outlive it. Cells are `cell` mm wide.
  OpenFloor(const Hardware& hardware, double cell, double stronger);

  /// One tick under these duties.
  void push(const Drive& drive);
  /// One tick under the controller's duties for these speeds.
  void follow(const Command& command);

  /// By tick, from the start on: mm along its path, and rad to the left.
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
