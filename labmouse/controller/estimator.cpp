#include "labmouse/controller/estimator.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/functions/whole.hpp"

namespace labmouse {
namespace {

/// Errors of gyro and slip are constant during a turn. To model them as noise per tick, their variance is scaled by the
/// duration of a turn, s.
constexpr double turn_seconds = 0.15;
/// The slope of the floor is the same for so much of a turn, mm: at low speed that is longer than `turn_seconds`.
constexpr double turn_length = 60.0;
/// Share of the gyro's scale error that remains after calibration, and relative error of the slip.
constexpr double gyro_rest = 0.2, slip_rest = 0.3;
/// Relative error of an angle that only the wheels measure: they roll on the edges of their tyres, assumed.
constexpr double wheel_rest = 0.03;
/// Slip that the nominal tyre model misses of any, rad.
constexpr double least_slip_error = 0.003;
/// mm/s²
constexpr double gravity = 9810.0;
/// Slip is measured above this turn rate (rad/s) and this speed (mm/s), and limited to `most_slip` (rad).
constexpr double least_turning = 2.0, least_speed = 100.0, most_slip = 0.5;

}  // namespace

Estimator::Estimator(const Hardware& hardware, double cell, double speed_filter)
    : hardware_(hardware),
      speed_filter_(speed_filter),
      floor_steps_a_mm_(hardware.variation.floor_steps / cell),
      offset_variance_(square(hardware.variation.acceleration_bias)) {}

void Estimator::put(const Position& position, const Direction& ahead) {
  const Variation& variation = hardware_.variation;
  position_ = position;
  ahead_ = ahead;
  const bool has_gyro = hardware_.sensors.has_gyro();
  // Wheels stay as they are, and the gyro is calibrated again.
  if (has_gyro) bias_ = 0.0;
  nominal_slip_ = felt_slip_ = slip_variance_ = speed_ = speeding_ = turning_ = 0.0;
  rejected_ = 0;
  const auto own = [&](State state, double deviation) { return any_ ? covariance_[state][state] : square(deviation); };
  constexpr double root_of_half = way_of_eighths(1).x;
  const double scale = own(at_scale, variation.encoder_scale), gyro = own(at_gyro, variation.gyro_scale),
               mismatch = own(at_bias, root_of_half * variation.encoder_scale / hardware_.chassis.half_track);
  covariance_ = {};
  // Twice the standard deviation of placement by hand, so that the first wall observations are not rejected.
  covariance_[at_x][at_x] = covariance_[at_y][at_y] = 4.0 * square(variation.placement);
  covariance_[at_angle][at_angle] = 4.0 * square(variation.placement_turn);
  // Without a gyro, wheels of different diameters turn the mouse as it drives.
  covariance_[at_bias][at_bias] = has_gyro ? square(hardware_.noise.gyro_bias) : mismatch;
  covariance_[at_scale][at_scale] = scale;
  covariance_[at_gyro][at_gyro] = gyro;
}

void Estimator::predict(const Sense& sense) {
  if (!any_) last_ = sense;
  if (any_ && sense.tick == last_.tick) return;
  any_ = true;
  const Sensors& sensors = hardware_.sensors;
  // In counts; a counter may have wrapped.
  const auto travel = [&](std::size_t wheel) {
    const auto now = static_cast<std::uint32_t>(sense.counts[wheel]),
               before = static_cast<std::uint32_t>(last_.counts[wheel]);
    return wrapped(now - before, sensors.count_bits);
  };
  const double counts = 0.5 * (travel(0) + travel(1));
  const double shown = counts * sensors.count, way = shown * (1.0 - scale_);
  const double seconds = std::max(1.0, static_cast<double>(sense.tick - last_.tick)) * tick_seconds;
  double turn = 0.0;
  if (sensors.has_gyro()) {
    turning_ = sense.gyro * sensors.gyro_step * (1.0 - gyro_) - bias_;
    turn = turning_ * seconds;
  } else {
    // The angle is that of the wheels; their rate is filtered, since a count is much in a tick.
    turn = (travel(1) - travel(0)) * sensors.count / (2.0 * hardware_.chassis.half_track) * (1.0 - gyro_) - way * bias_;
    turning_ += speed_filter_ * (turn / seconds - turning_);
  }
  if (sensors.has_accelerometer()) {
    const double rate = sense.acceleration[0] * sensors.acceleration_step;
    speed_ = speed_filter_ * way / seconds + (1.0 - speed_filter_) * (speed_ + rate * seconds);
  } else {
    track_speed(way, seconds);
  }
  last_ = sense;

  const double pulled = sense.acceleration[1] * sensors.acceleration_step;
  if (sensors.has_accelerometer()) measure_offset(pulled, seconds);
  estimate_slip(pulled - offset_, turn, seconds);
  const Direction went = turned_by(ahead_, turn / 2.0 + felt_slip_);
  position_ = {position_.x + way * went.cosine, position_.y + way * went.sine};
  ahead_ = turned_by(ahead_, turn);
  spread(way, turn, seconds, went);
  add_noise(way, turn, seconds);
}

/// Without an accelerometer, an alpha-beta filter follows the speed of the wheels and its rate.
void Estimator::track_speed(double way, double seconds) {
  speed_ += speeding_ * seconds;
  const double error = way / seconds - speed_;
  speed_ += speed_filter_ * error;
  // The second weight is that of Benedict and Bordner (1962) for the first.
  speeding_ += square(speed_filter_) / (2.0 - speed_filter_) * error / seconds;
}

/// On straights the lateral acceleration is that of the path; what is felt besides is the offset, the noise, and the
/// slope of the floor, which is the same for a moment.
void Estimator::measure_offset(double pulled, double seconds) {
  constexpr double turns = 0.5;                      // rad/s
  constexpr double settled = 0.1, same_slope = 0.3;  // s
  straight_ = std::abs(turning_) > turns ? 0.0 : straight_ + seconds;
  if (straight_ < settled) return;
  const double slope = gravity * hardware_.variation.floor_tilt;
  const double variance =
      1.0 + square(hardware_.noise.acceleration) + square(slope) * std::max(1.0, same_slope / seconds);
  const double gain = offset_variance_ / (offset_variance_ + variance);
  offset_ += gain * (pulled - speed_ * turning_ - offset_);
  offset_variance_ *= 1.0 - gain;
}

void Estimator::estimate_slip(double pulled, double turn, double seconds) {
  const Tyres& tyres = hardware_.tyres;
  constexpr double slow = 20.0;
  const double speed = std::max(std::abs(speed_), slow);
  nominal_slip_ = (nominal_slip_ - turn) / (1.0 + tyres.stiffness * seconds / speed);
  const double most = tyres.grip / tyres.stiffness;
  nominal_slip_ = std::clamp(nominal_slip_, -most, most);
  const double share = hardware_.variation.stiffness;
  const double nominal_variance = square(share * nominal_slip_) + square(least_slip_error);
  if (!feels_slip()) {
    felt_slip_ = nominal_slip_;
    slip_variance_ = nominal_variance;
    return;
  }
  // The lateral acceleration gives the turn rate of the path, and any further turn of the mouse is slip.
  felt_slip_ += pulled / speed_ * seconds - turn;
  const double slope = gravity * hardware_.variation.floor_tilt;
  slip_variance_ += (square(hardware_.noise.acceleration) * seconds +
                     (offset_variance_ + square(slope)) * std::max(turn_seconds, turn_length / speed_)) *
                    seconds / square(speed_);
  // The error of the nominal model is the same during a turn. The more it disagrees, beyond the error of what is felt,
  // the less it counts: tyres that slide follow no model.
  const double off = nominal_slip_ - felt_slip_, unexplained = std::max(0.0, square(off) - slip_variance_);
  const double gain =
      slip_variance_ / (slip_variance_ + (nominal_variance + unexplained) * std::max(1.0, turn_seconds / seconds));
  felt_slip_ += gain * off;
  slip_variance_ *= 1.0 - gain;
  felt_slip_ = std::clamp(felt_slip_, -most_slip, most_slip);
}

bool Estimator::feels_slip() const {
  return hardware_.sensors.has_accelerometer() && std::abs(turning_) > least_turning && speed_ > least_speed;
}

/// Propagates errors of the angle, the gyro bias and the scales to the position and the angle.
void Estimator::spread(double way, double turn, double seconds, const Direction& went) {
  const double biased = hardware_.sensors.has_gyro() ? seconds : way;
  const double x_angle = -way * went.sine, y_angle = way * went.cosine;
  const double x_scale = -way * went.cosine, y_scale = -way * went.sine;
  auto& p = covariance_;
  for (std::size_t i = 0; i < states; ++i) {
    p[at_x][i] += x_angle * p[at_angle][i] + x_scale * p[at_scale][i];
    p[at_y][i] += y_angle * p[at_angle][i] + y_scale * p[at_scale][i];
    p[at_angle][i] -= biased * p[at_bias][i] + turn * p[at_gyro][i];
  }
  for (std::size_t i = 0; i < states; ++i) {
    p[i][at_x] += x_angle * p[i][at_angle] + x_scale * p[i][at_scale];
    p[i][at_y] += y_angle * p[i][at_angle] + y_scale * p[i][at_scale];
    p[i][at_angle] -= biased * p[i][at_bias] + turn * p[i][at_gyro];
  }
}

void Estimator::add_noise(double way, double turn, double seconds) {
  const Noise& noise = hardware_.noise;
  const Variation& variation = hardware_.variation;
  const double length = std::abs(way);
  const double again = std::max(1.0, turn_seconds / seconds);
  // Encoders: ripple and residual wheel slip.
  const double along = square(0.02 * way) + 2e-5 * length * square(noise.ripple);
  // Slip: the error of the filter, and one in proportion to it.
  const double slip = (feels_slip() ? slip_variance_ : 0.0) + square(slip_rest * felt_slip_);
  const double across = again * slip * square(way) + floor_steps_a_mm_ * square(variation.floor_shift) * length;
  const double share = hardware_.sensors.has_gyro() ? gyro_rest * variation.gyro_scale : wheel_rest;
  const double moment = hardware_.sensors.has_gyro() ? noise.gyro * seconds : 0.0;
  const double angle =
      again * square(share * turn) + square(moment) + floor_steps_a_mm_ * square(variation.floor_turn) * length;
  const double c = ahead_.cosine, s = ahead_.sine;
  covariance_[at_x][at_x] += along * c * c + across * s * s;
  covariance_[at_y][at_y] += along * s * s + across * c * c;
  covariance_[at_x][at_y] += (along - across) * c * s;
  covariance_[at_y][at_x] += (along - across) * c * s;
  covariance_[at_angle][at_angle] += angle;
  if (hardware_.sensors.has_gyro()) covariance_[at_bias][at_bias] += square(noise.gyro_walk) * seconds;
}

bool Estimator::correct(const Observation& seen) {
  auto& p = covariance_;
  Row gain{};
  for (std::size_t i = 0; i < states; ++i)
    gain[i] = p[i][at_x] * seen.by_x + p[i][at_y] * seen.by_y + p[i][at_angle] * seen.by_angle;
  const double variance =
      seen.by_x * gain[at_x] + seen.by_y * gain[at_y] + seen.by_angle * gain[at_angle] + seen.variance;
  constexpr double most_deviations = 3.0;
  if (square(seen.error) > square(most_deviations) * variance) {
    doubt();
    return false;
  }
  rejected_ = 0;
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

/// An observation was rejected.
void Estimator::doubt() {
  constexpr int many = 20;
  if (++rejected_ < many) return;
  rejected_ = 0;
  for (std::size_t i = 0; i < states; ++i)
    for (const std::size_t pose : {at_x, at_y, at_angle}) {
      covariance_[pose][i] *= 2.0;
      covariance_[i][pose] *= 2.0;
    }
}

PoseEstimate Estimator::estimate() const {
  PoseEstimate told = {position_, ahead_, nominal_slip_, speed_, turning_, {}};
  static_assert(at_x == 0 && at_y == 1 && at_angle == 2);
  for (std::size_t row = 0; row < told.covariance.size(); ++row)
    std::copy_n(covariance_[row].begin(), told.covariance.size(), told.covariance[row].begin());
  return told;
}

}  // namespace labmouse
