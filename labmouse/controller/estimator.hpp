// Where a mouse believes to be, and how sure it is.
//
// Method: an extended Kalman filter over x, y, the angle, the bias of the gyro, and what differs from mouse to mouse:
// by how much the encoders overstate a way, and the gyro a turn. Encoders and gyro say how it moved, and in turns the
// accelerometer how it slips; what is seen of walls corrects it, one number at a time. What a mouse has found out about
// itself it keeps when it is put down elsewhere.
#pragma once

#include <array>
#include <cstddef>

#include "labmouse/controller/pose_estimate.hpp"
#include "labmouse/functions/angles.hpp"
#include "labmouse/functions/position.hpp"
#include "labmouse/hardware/hardware.hpp"
#include "labmouse/hardware/sense.hpp"

namespace labmouse {

/// A number that was seen, beside what it should be by the estimate: seen less expected, how it should change with x, y
/// (in mm) and the angle (in rad), and the variance of what was seen.
struct Observation {
  double error = 0.0;
  double by_x = 0.0, by_y = 0.0, by_angle = 0.0;
  double variance = 1.0;
};

class Estimator {
 public:
  /// The hardware must outlive it.
  Estimator(const Hardware& hardware, double cell, double speed_filter);

  /// It was put there, about, and stands.
  void put(const Position& position, const Direction& ahead);
  /// What was read since the last time: of one tick, or of several where some were left out.
  void predict(const Sense& sense);
  /// Believes an observation, unless it is more than three deviations off; whether it did.
  bool correct(const Observation& observation);

  const Position& position() const { return position_; }
  /// Where it points, and where it goes.
  const Direction& ahead() const { return ahead_; }
  Direction way() const { return turned_by(ahead_, slip()); }
  /// As it feels it. An estimate tells of the slip of the nominal model instead: a mouse that steers by what it feels
  /// while its tyres slide turns in more, and slides more.
  double slip() const { return felt_slip_; }
  double speed() const { return speed_; }      ///< mm/s
  double turning() const { return turning_; }  ///< rad/s
  PoseEstimate estimate() const;
  /// As of PoseEstimate.
  double variance_of(double x, double y, double angle) const { return estimate().variance_of(x, y, angle); }

 private:
  static constexpr std::size_t states = 6;
  enum State : std::size_t { at_x, at_y, at_angle, at_bias, at_scale, at_gyro };
  using Row = std::array<double, states>;

  void spread(double way, double turn, const Direction& went);
  void add_noise(double way);
  /// Whether it turns and drives fast enough to feel how it slips.
  bool feels_slip() const;

  const Hardware& hardware_;
  double speed_filter_;
  double floor_steps_a_mm_;
  Position position_;
  Direction ahead_;
  double bias_ = 0.0;   ///< rad/s that the gyro shows at rest
  double scale_ = 0.0;  ///< share by which encoders overstate
  double gyro_ = 0.0;   ///< share by which the gyro does
  double nominal_slip_ = 0.0, felt_slip_ = 0.0;
  double speed_ = 0.0, turning_ = 0.0;
  std::array<Row, states> covariance_{};
  Sense last_;
  bool any_ = false;
};

}  // namespace labmouse
