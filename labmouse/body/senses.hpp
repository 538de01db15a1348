// The simulated sensors: encoders, gyro, accelerometer, infrared and ToF sensors, with their errors, as raw integers.
#pragma once

#include <array>
#include <cstdint>

#include "labmouse/body/beams.hpp"
#include "labmouse/body/plant.hpp"
#include "labmouse/chance/rng.hpp"
#include "labmouse/hardware/sense.hpp"

namespace labmouse {

class Senses {
 public:
  /// All must outlive it.
  Senses(const Field& field, const Hardware& hardware, const RobotSample& robot_sample, std::uint64_t seed);

  /// Calibrates the gyro at rest, which draws a new bias.
  void calibrate();
  /// Reads everything after a tick.
  void read(const BodyMotion& motion, double voltage);
  const Sense& sense() const { return sense_; }

 private:
  void count(const BodyMotion& motion);
  void turn(const BodyMotion& motion);
  void accelerate(const BodyMotion& motion);
  void shine(const BodyMotion& motion);
  void range(const BodyMotion& motion);

  const Hardware& hardware_;
  const RobotSample& robot_sample_;
  Beams beams_;
  Sense sense_;
  /// Random generators by source, so that none depends on whether others are used.
  std::array<Rng, 2> encoder_rng_;
  Rng gyro_rng_, bias_rng_, walk_rng_;
  std::array<Rng, 2> acceleration_rng_;
  std::array<Rng, beam_count> infrared_rng_;
  Rng range_rng_;
  std::array<Rng, beam_count> ambient_rng_;
  std::array<double, beam_count> ambient_;  ///< counts
  double infrared_fresh_;                   ///< factor of the new noise in a beam's error, an AR(1) process
  std::array<double, 2> travel_{};          ///< mm, of each wheel as its encoder measures it
  double bias_ = 0.0;                       ///< rad/s
  std::array<double, beam_count> infrared_noise_{};
  int until_range_ = 0;  ///< ticks to the next reading
};

}  // namespace labmouse
