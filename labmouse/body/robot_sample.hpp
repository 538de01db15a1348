// A random sample of a robot and its maze, drawn once a contest: the actual values of what the hardware states
// nominally.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "labmouse/body/error_scale.hpp"
#include "labmouse/functions/position.hpp"
#include "labmouse/grid/wall.hpp"
#include "labmouse/hardware/beam.hpp"

namespace labmouse {

/// A step of the floor at a boundary between two cells, as it is met when it is crossed north- or eastwards.
struct FloorStep {
  double turn = 0.0;   ///< rad to the left
  double shift = 0.0;  ///< mm to the left
};

/// The floor of a cell.
struct Floor {
  Position slope;     ///< by how much it rises per mm to the east and to the north
  double grip = 1.0;  ///< factor of the tyres' grip on its dust
};

/// The sample of one contest. Each cause of errors has a random generator of its own, so that none depends on what
/// others draw.
class RobotSample {
 public:
  RobotSample(const Hardware& hardware, const ErrorScale& scale, Size size, std::uint64_t seed);

  /// The severity score of this sample: the fourth-power mean of the draws of motors, tyres, gyro and infrared sensors,
  /// each in standard deviations at variation 1. The high power makes a single bad number count.
  double severity() const { return severity_; }
  /// How bright walls look to its sensors on average, as a factor of what is nominal.
  double brightness() const;
  /// How bright a side of a cell looks to the infrared sensors that look there, as a factor of what is nominal: as
  /// reflectance() where a wall stands, or as walls do on average.
  double brightness(BeamSide looks, Cell cell, Heading side, bool wall) const;
  /// The factor of a cause's noise.
  double noise_of(ErrorCause cause) const { return scale_.noise_of(cause); }
  /// The factor of a cause's variation.
  double variation_of(ErrorCause cause) const { return scale_.variation_of(cause); }

  /// The reflectance of a side of a cell, as a factor of the nominal one.
  double reflectance(Cell cell, Heading side) const;
  FloorStep floor_step(Wall boundary) const;
  Floor floor(Cell cell) const;
  /// By how much each post is off its place in mm, row by row from the south-western one; empty if all are in place.
  const std::vector<Position>& post_shifts() const { return post_shifts_; }

  std::array<double, 2> motor{};         ///< factor of each motor's duty, left and right
  double battery = 1.0;                  ///< factor of the voltage at rest, at the start
  double stiffness = 1.0, grip = 1.0;    ///< factors
  std::array<double, 2> encoder{};       ///< factor of each wheel's travel, as it counts it
  std::array<double, 2> ripple{};        ///< phases of the magnets' ripple, in turns
  double gyro = 1.0;                     ///< factor
  std::array<double, 2> acceleration{};  ///< mm/s², offsets of both axes
  std::vector<double> infrared;          ///< factors
  std::vector<double> ambient;           ///< counts of each infrared sensor, at the start

 private:
  void draw_maze(const Variation& variation, std::uint64_t seed);

  ErrorScale scale_;
  std::vector<BeamSide> looks_;  ///< of each infrared sensor
  double severity_ = 0.0;
  Size size_;
  double maze_reflectance_ = 1.0;
  std::vector<float> reflectances_;     ///< by four sides of each cell
  std::vector<FloorStep> floor_steps_;  ///< by the north and the east side of each cell; empty without any
  std::vector<Floor> floors_;           ///< by cell; empty if all are level and clean
  std::vector<Position> post_shifts_;
};

}  // namespace labmouse
