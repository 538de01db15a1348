// One mouse on one day: what the numbers of its maker became, and the maze as it was built.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "labmouse/body/noise_level.hpp"
#include "labmouse/grid/wall.hpp"

namespace labmouse {

/// A step of the floor at a boundary between two cells, as it is met when it is crossed north- or eastwards.
struct FloorStep {
  double turn = 0.0;   ///< rad to the left
  double shift = 0.0;  ///< mm to the left
};

/// Drawn once a contest, each number from dice of its own, so that none depends on whether others are drawn.
class RobotSample {
 public:
  RobotSample(const Hardware& hardware, const NoiseLevel& level, Size size, std::uint64_t seed);

  /// How unlucky this contest's draws are: the fourth-power mean of what motors, tyres and gyro drew, each in
  /// deviations of a mouse at noise 1 and variation 1. One bad number is enough to break a mouse.
  double severity() const { return severity_; }
  /// The factor of its weaker motor.
  double weaker_motor() const { return motor[0] < motor[1] ? motor[0] : motor[1]; }
  /// How far its infrared sensors are from what they should be: the root mean square of their factors' logarithms.
  double eyes_apart() const { return eyes_apart_; }
  /// The factor of a group's noise.
  double level(NoiseGroup group) const { return level_.of(group); }

  /// As a side of a cell reflects, 1 in the mean.
  double reflectance(Cell cell, Heading side) const;
  FloorStep floor_step(Wall boundary) const;

  std::array<double, 2> motor{};              ///< factor of each motor's duty, left and right
  double stiffness = 1.0, grip = 1.0;         ///< factors
  std::array<double, 2> encoder{};            ///< factor of each wheel's travel, as it counts it
  std::array<double, 2> ripple{};             ///< turns of the magnets by which they are ahead
  double gyro = 1.0;                          ///< factor
  std::array<double, beam_count> infrared{};  ///< factors

 private:
  NoiseLevel level_;
  double severity_ = 0.0, eyes_apart_ = 0.0;
  Size size_;
  std::vector<float> reflectances_;     ///< by four sides of each cell
  std::vector<FloorStep> floor_steps_;  ///< by the north and the east side of each cell; empty without any
};

}  // namespace labmouse
