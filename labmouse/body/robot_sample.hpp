// A random sample of a robot and its maze, drawn once a contest: the actual values of what the hardware states
// nominally.
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

/// The sample of one contest. Each group has a random generator of its own, so that none depends on what others draw.
class RobotSample {
 public:
  RobotSample(const Hardware& hardware, const NoiseLevel& level, Size size, std::uint64_t seed);

  /// The severity score of this sample: the fourth-power mean of the draws of motors, tyres and gyro, each in standard
  /// deviations at noise 1 and variation 1. The high power makes a single bad number count.
  double severity() const { return severity_; }
  /// The factor of its weaker motor.
  double weaker_motor() const { return motor[0] < motor[1] ? motor[0] : motor[1]; }
  /// Root mean square of the logarithms of the infrared sensors' factors.
  double infrared_deviation() const { return infrared_deviation_; }
  /// The factor of a group's noise.
  double level(NoiseGroup group) const { return level_.of(group); }

  /// The reflectance of a side of a cell, as a factor of the nominal one.
  double reflectance(Cell cell, Heading side) const;
  FloorStep floor_step(Wall boundary) const;

  std::array<double, 2> motor{};              ///< factor of each motor's duty, left and right
  double stiffness = 1.0, grip = 1.0;         ///< factors
  std::array<double, 2> encoder{};            ///< factor of each wheel's travel, as it counts it
  std::array<double, 2> ripple{};             ///< phases of the magnets' ripple, in turns
  double gyro = 1.0;                          ///< factor
  std::array<double, beam_count> infrared{};  ///< factors

 private:
  NoiseLevel level_;
  double severity_ = 0.0, infrared_deviation_ = 0.0;
  Size size_;
  std::vector<float> reflectances_;     ///< by four sides of each cell
  std::vector<FloorStep> floor_steps_;  ///< by the north and the east side of each cell; empty without any
};

}  // namespace labmouse
