#include "labmouse/controller/estimator.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/functions/whole.hpp"

namespace labmouse {
namespace {

/// Errors of gyro and slip are constant during a turn. To model them as noise per tick, their variance is scaled by the
/// duration of a turn, s.
constexpr double turn_seconds = 0.15;
/// Share of the gyro's scale error that remains after calibration, and relative error of the measured slip.
constexpr double gyro_rest = 0.2, slip_rest = 0.3;
/// Slip is measured above this turn rate (rad/s) and this speed (mm/s), and limited to `most_slip` (rad).
constexpr double least_turning = 2.0, least_speed = 100.0, most_slip = 0.5;

}  // namespace

Estimator::Estimator(const Hardware& hardware, double cell, double speed_filter)
    : hardware_(hardware), speed_filter_(speed_filter), floor_steps_a_mm_(hardware.noise.floor_steps / cell) {}

void Estimator::put(const Position& position, const Direction& ahead) {
  const Noise& noise = hardware_.noise;
  position_ = position;
  ahead_ = ahead;
  bias_ = nominal_slip_ = felt_slip_ = speed_ = turning_ = 0.0;
  const auto own = [&](State state, double deviation) { return any_ ? covariance_[state][state] : square(deviation); };
  const double scale = own(at_scale, noise.encoder_scale), gyro = own(at_gyro, noise.gyro_scale);
  covariance_ = {};
  // Twice the standard deviation of placement by hand, so that the first wall observations are not rejected.
  covariance_[at_x][at_x] = covariance_[at_y][at_y] = 4.0 * square(noise.placement);
  covariance_[at_angle][at_angle] = 4.0 * square(noise.placement_turn);
  covariance_[at_bias][at_bias] = square(noise.gyro_bias);
  covariance_[at_scale][at_scale] = scale;
  covariance_[at_gyro][at_gyro] = gyro;
}

void Estimator::predict(const Sense& sense) {
  if (!any_) last_ = sense;
  if (any_ && sense.tick == last_.tick) return;
  any_ = true;
  const double counts = 0.5 * ((sense.counts[0] - last_.counts[0]) + (sense.counts[1] - last_.counts[1]));
  const double shown = counts * hardware_.sensors.count, way = shown * (1.0 - scale_);
  turning_ = sense.gyro * hardware_.sensors.gyro_step * (1.0 - gyro_) - bias_;
  const double rate = sense.acceleration[0] * hardware_.sensors.acceleration_step;
  const double ticks = std::max(1.0, static_cast<double>(sense.tick - last_.tick));
  speed_ =
      speed_filter_ * way / (ticks * tick_seconds) + (1.0 - speed_filter_) * (speed_ + rate * ticks * tick_seconds);
  last_ = sense;

  // Slip angle by the nominal tyre model.
  constexpr double slow = 20.0;
  const double speed = std::max(std::abs(speed_), slow);
  const double turn = turning_ * ticks * tick_seconds;
  nominal_slip_ = (nominal_slip_ - turn) / (1.0 + hardware_.tyres.stiffness * ticks * tick_seconds / speed);
  const double most = hardware_.tyres.grip / hardware_.tyres.stiffness;
  nominal_slip_ = std::clamp(nominal_slip_, -most, most);
  // Measured slip: the lateral acceleration gives the turn rate of the path, and any further turn of the mouse is slip.
  // It is integrated only in turns: over longer times the noise of the accelerometer would exceed the slip.
  if (feels_slip()) {
    const double pulled = sense.acceleration[1] * hardware_.sensors.acceleration_step;
    felt_slip_ += pulled / speed_ * ticks * tick_seconds - turn;
    felt_slip_ = std::clamp(felt_slip_, -most_slip, most_slip);
  } else {
    felt_slip_ = nominal_slip_;
  }

  const Direction went = turned_by(ahead_, turn / 2.0 + felt_slip_);
  position_ = {position_.x + way * went.cosine, position_.y + way * went.sine};
  ahead_ = turned_by(ahead_, turn);
  spread(way, turn, went);
  add_noise(way);
}

bool Estimator::feels_slip() const { return std::abs(turning_) > least_turning && speed_ > least_speed; }

/// Propagates errors of the angle, the gyro bias and the scales to the position and the angle.
void Estimator::spread(double way, double turn, const Direction& went) {
  const double x_angle = -way * went.sine, y_angle = way * went.cosine;
  const double x_scale = -way * went.cosine, y_scale = -way * went.sine;
  auto& p = covariance_;
  for (std::size_t i = 0; i < states; ++i) {
    p[at_x][i] += x_angle * p[at_angle][i] + x_scale * p[at_scale][i];
    p[at_y][i] += y_angle * p[at_angle][i] + y_scale * p[at_scale][i];
    p[at_angle][i] -= tick_seconds * p[at_bias][i] + turn * p[at_gyro][i];
  }
  for (std::size_t i = 0; i < states; ++i) {
    p[i][at_x] += x_angle * p[i][at_angle] + x_scale * p[i][at_scale];
    p[i][at_y] += y_angle * p[i][at_angle] + y_scale * p[i][at_scale];
    p[i][at_angle] -= tick_seconds * p[i][at_bias] + turn * p[i][at_gyro];
  }
}

void Estimator::add_noise(double way) {
  const Noise& noise = hardware_.noise;
  const double turn = turning_ * tick_seconds, length = std::abs(way);
  constexpr double again = turn_seconds / tick_seconds;
  // Encoders: ripple and residual wheel slip.
  const double along = square(0.02 * way) + 2e-5 * length * square(noise.ripple);
  // Noise of the accelerometer, integrated over a turn, and an error proportional to the slip.
  const double shaken = feels_slip() ? noise.acceleration / speed_ * std::sqrt(tick_seconds * turn_seconds) : 0.0;
  const double across = again * (square(shaken) + square(slip_rest * felt_slip_)) * square(way) +
                        floor_steps_a_mm_ * square(noise.floor_shift) * length;
  const double angle = again * square(gyro_rest * noise.gyro_scale * turn) + square(noise.gyro * tick_seconds) +
                       floor_steps_a_mm_ * square(noise.floor_turn) * length;
  const double c = ahead_.cosine, s = ahead_.sine;
  covariance_[at_x][at_x] += along * c * c + across * s * s;
  covariance_[at_y][at_y] += along * s * s + across * c * c;
  covariance_[at_x][at_y] += (along - across) * c * s;
  covariance_[at_y][at_x] += (along - across) * c * s;
  covariance_[at_angle][at_angle] += angle;
  covariance_[at_bias][at_bias] += square(noise.gyro_walk) * tick_seconds;
}

bool Estimator::correct(const Observation& seen) {
  auto& p = covariance_;
  Row gain{};
  for (std::size_t i = 0; i < states; ++i)
    gain[i] = p[i][at_x] * seen.by_x + p[i][at_y] * seen.by_y + p[i][at_angle] * seen.by_angle;
  const double variance =
      seen.by_x * gain[at_x] + seen.by_y * gain[at_y] + seen.by_angle * gain[at_angle] + seen.variance;
  constexpr double most_deviations = 3.0;
  if (square(seen.error) > square(most_deviations) * variance) return false;
  const double part = seen.error / variance;
  position_ = {position_.x + part * gain[at_x], position_.y + part * gain[at_y]};
  ahead_ = turned_by(ahead_, part * gain[at_angle]);
  bias_ += part * gain[at_bias];
  scale_ += part * gain[at_scale];
  gyro_ += part * gain[at_gyro];
  for (std::size_t i = 0; i < states; ++i)
    for (std::size_t j = 0; j < states; ++j) p[i][j] -= gain[i] * gain[j] / variance;
  return true;
}

PoseEstimate Estimator::estimate() const {
  PoseEstimate told = {position_, ahead_, nominal_slip_, speed_, turning_, {}};
  static_assert(at_x == 0 && at_y == 1 && at_angle == 2);
  for (std::size_t row = 0; row < told.covariance.size(); ++row)
    std::copy_n(covariance_[row].begin(), told.covariance.size(), told.covariance[row].begin());
  return told;
}

}  // namespace labmouse
