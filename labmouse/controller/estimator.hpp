// Estimates the pose of a mouse, and its covariance.
//
// Method: an extended Kalman filter over x, y, the angle, the gyro bias, and the scale errors of encoders and gyro,
// which differ between mice. Encoders and gyro predict the motion. Two scalar filters beside it give the offset of the
// lateral accelerometer, and the slip angle in turns: the integral of the lateral acceleration, weighed against the
// nominal tyre model. Wall observations correct the state, one scalar at a time. The scale errors and the offset are
// kept when the mouse is put down elsewhere. Without a gyro the wheels measure the turns, and the bias is that of their
// diameters; without an accelerometer the slip is that of the nominal tyre model.
#pragma once

#include <array>
#include <cstddef>

#include "labmouse/controller/pose_estimate.hpp"
#include "labmouse/functions/angles.hpp"
#include "labmouse/functions/position.hpp"
#include "labmouse/hardware/hardware.hpp"
#include "labmouse/hardware/sense.hpp"

namespace labmouse {

/// A scalar observation: measured less expected value, the derivatives of the expected value by x, y (per mm) and the
/// angle (per rad), and the variance of the measurement.
struct Observation {
  double error = 0.0;
  double by_x = 0.0, by_y = 0.0, by_angle = 0.0;
  double variance = 1.0;
};

class Estimator {
 public:
  /// The hardware must outlive it.
  Estimator(const Hardware& hardware, double cell, double speed_filter);

  /// Sets the pose: the mouse was put about there, and is at rest.
  void put(const Position& position, const Direction& ahead);
  /// Predicts the motion since the last call. Ticks may have been left out.
  void predict(const Sense& sense);
  /// Applies an observation unless it is more than three standard deviations off. Returns whether it was applied. After
  /// many in a row that were not, the pose counts as less certain, so that a lost mouse can find itself again.
  bool correct(const Observation& observation);

  const Position& position() const { return position_; }
  /// The direction in which it points, and in which it moves.
  const Direction& ahead() const { return ahead_; }
  Direction way() const { return turned_by(ahead_, slip()); }
  /// The slip angle, rad. estimate() has that of the nominal tyre model instead: steering by the
  /// measured slip while the tyres slide makes the mouse turn in more, and slide more.
  double slip() const { return felt_slip_; }
  double speed() const { return speed_; }      ///< mm/s
  double turning() const { return turning_; }  ///< rad/s
  PoseEstimate estimate() const;
  /// See PoseEstimate.
  double variance_of(double x, double y, double angle) const { return estimate().variance_of(x, y, angle); }

 private:
  static constexpr std::size_t states = 6;
  enum State : std::size_t { at_x, at_y, at_angle, at_bias, at_scale, at_gyro };
  using Row = std::array<double, states>;

  void measure_offset(double pulled, double seconds);
  void estimate_slip(double pulled, double turn, double seconds);
  void spread(double way, double turn, double seconds, const Direction& went);
  void track_speed(double way, double seconds);
  void add_noise(double way, double turn, double seconds);
  void doubt();
  /// Whether it turns and drives fast enough to measure its slip.
  bool feels_slip() const;

  const Hardware& hardware_;
  double speed_filter_;
  double floor_steps_a_mm_;
  Position position_;
  Direction ahead_;
  double bias_ = 0.0;                      ///< gyro rate at rest, rad/s; without a gyro rad/mm that it turns
  double scale_ = 0.0;                     ///< relative error of the encoders' scale
  double gyro_ = 0.0;                      ///< relative error of the gyro's scale
  double offset_ = 0.0, offset_variance_;  ///< of the lateral accelerometer, mm/s²
  double straight_ = 0.0;                  ///< s since it last turned
  double nominal_slip_ = 0.0, felt_slip_ = 0.0, slip_variance_ = 0.0;
  int rejected_ = 0;  ///< observations in a row
  double speed_ = 0.0, turning_ = 0.0;
  double speeding_ = 0.0;  ///< mm/s²; without an accelerometer only
  std::array<Row, states> covariance_{};
  Sense last_;
  bool any_ = false;
};

}  // namespace labmouse
