// The simulated sensors: encoders, gyro, accelerometer, infrared and ToF sensors, with their errors, as raw integers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

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
  /// An infrared sensor.
  struct InfraredState {
    Rng noise_rng, ambient_rng;
    double ambient = 0.0;               ///< counts
    double noise = 0.0;                 ///< in standard deviations, an AR(1) process
    std::int16_t last = 0;              ///< reading
    std::vector<std::int16_t> delayed;  ///< readings of the last ticks, as many as its latency, in a ring
  };
  std::vector<InfraredState> infrared_;
  unsigned groups_ = 1;       ///< of infrared sensors
  bool was_put_down_ = true;  ///< whether the mouse was put down since the last tick
  /// A ToF sensor.
  struct RangerState {
    Rng rng;
    int until_new = 0;  ///< ticks to the next reading
  };
  std::vector<RangerState> rangers_;
  double fresh_;                    ///< factor of the new noise in that of an infrared sensor
  std::array<double, 2> travel_{};  ///< mm, of each wheel as its encoder measures it
  double bias_ = 0.0;               ///< rad/s
};

}  // namespace labmouse
