#include "labmouse/body/senses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "labmouse/functions/normal.hpp"
#include "labmouse/functions/whole.hpp"

namespace labmouse {
namespace {

double normal(Rng& rng) { return NormalNumber::of(rng.bits()); }

constexpr double root_of_tick = 0.0316227766016837933;  // of its seconds

/// To the nearest whole number, cut to what the register holds.
std::int16_t in_register(double number) {
  constexpr double most = std::numeric_limits<std::int16_t>::max();
  return static_cast<std::int16_t>(whole_below(std::min(std::max(number, -most), most) + 0.5));
}

/// The whole counts below a number, modulo 2^32.
std::uint32_t counts_below(double number) {
  const auto count = static_cast<std::int64_t>(number);
  return static_cast<std::uint32_t>(static_cast<double>(count) > number ? count - 1 : count);
}

}  // namespace

Senses::Senses(const Field& field, const Hardware& hardware, const RobotSample& robot_sample, std::uint64_t seed)
    : hardware_(hardware),
      robot_sample_(robot_sample),
      beams_(field, hardware.sensors, robot_sample),
      encoder_rng_{Rng(seed_for(seed, "left encoder")), Rng(seed_for(seed, "right encoder"))},
      gyro_rng_(seed_for(seed, "gyro noise")),
      bias_rng_(seed_for(seed, "gyro bias")),
      walk_rng_(seed_for(seed, "gyro walk")),
      acceleration_rng_{Rng(seed_for(seed, "acceleration ahead")), Rng(seed_for(seed, "acceleration aside"))},
      fresh_(std::sqrt(1.0 - square(hardware.noise.infrared_memory))) {
  for (std::size_t i = 0; i < hardware.sensors.infrared.size(); ++i) {
    const Infrared& sensor = hardware.sensors.infrared[i];
    infrared_.push_back({Rng(seed_for(seed, "infrared", i)), Rng(seed_for(seed, "ambient", i)), robot_sample.ambient[i],
                         0.0, 0, std::vector<std::int16_t>(static_cast<std::size_t>(sensor.latency))});
    groups_ = std::max(groups_, static_cast<unsigned>(sensor.group) + 1);
  }
  sense_.infrared_sensors = static_cast<std::uint8_t>(infrared_.size());
  sense_.range_sensors = static_cast<std::uint8_t>(hardware.sensors.rangers.size());
  for (std::size_t i = 0; i < hardware.sensors.rangers.size(); ++i)
    rangers_.push_back({i == 0 ? Rng(seed_for(seed, "ranger")) : Rng(seed_for(seed, "ranger", i))});
}

void Senses::calibrate() {
  was_put_down_ = true;
  bias_ = robot_sample_.noise_of(ErrorCause::gyro) * hardware_.noise.gyro_bias * normal(bias_rng_);
}

void Senses::read(const BodyMotion& motion, double voltage) {
  ++sense_.tick;
  count(motion);
  turn(motion);
  accelerate(motion);
  shine(motion);
  range(motion);
  sense_.millivolts = static_cast<std::uint16_t>(whole_below(1000.0 * hardware_.motors.volts * voltage + 0.5));
}

void Senses::count(const BodyMotion& motion) {
  const Noise& noise = hardware_.noise;
  const double level = robot_sample_.noise_of(ErrorCause::encoders);
  const double around = hardware_.chassis.half_track * motion.yaw;
  for (const std::size_t wheel : {std::size_t{0}, std::size_t{1}}) {
    travel_[wheel] += robot_sample_.encoder[wheel] * (motion.rolling + (wheel == 0 ? -around : around)) * tick_seconds;
    double shown = travel_[wheel];
    if (level > 0.0) {
      const double turns = travel_[wheel] / noise.ripple_length + robot_sample_.ripple[wheel];
      shown += level * (noise.ripple * sine_of_turns(turns) + noise.encoder * normal(encoder_rng_[wheel]));
    }
    sense_.counts[wheel] = wrapped(counts_below(shown / hardware_.sensors.count), hardware_.sensors.count_bits);
  }
}

void Senses::turn(const BodyMotion& motion) {
  if (!hardware_.sensors.has_gyro()) return;
  const Noise& noise = hardware_.noise;
  const double level = robot_sample_.noise_of(ErrorCause::gyro);
  double rate = robot_sample_.gyro * motion.yaw;
  if (level > 0.0) {
    bias_ += level * noise.gyro_walk * root_of_tick * normal(walk_rng_);
    rate += bias_ + level * noise.gyro * normal(gyro_rng_);
  }
  rate = std::clamp(rate, -hardware_.sensors.gyro_most, hardware_.sensors.gyro_most);
  sense_.gyro = in_register(rate / hardware_.sensors.gyro_step);
}

void Senses::accelerate(const BodyMotion& motion) {
  if (!hardware_.sensors.has_accelerometer()) return;
  const double deviation = robot_sample_.noise_of(ErrorCause::accelerometer) * hardware_.noise.acceleration;
  // It feels what holds the mouse against gravity.
  std::array<double, 2> rates = {motion.speeding - motion.pull.x, motion.sideways};
  if (motion.speed == 0.0) rates[1] -= motion.pull.y;
  for (std::size_t axis = 0; axis < rates.size(); ++axis) {
    rates[axis] += robot_sample_.acceleration[axis];
    if (deviation > 0.0) rates[axis] += deviation * normal(acceleration_rng_[axis]);
    sense_.acceleration[axis] = in_register(rates[axis] / hardware_.sensors.acceleration_step);
  }
}

void Senses::shine(const BodyMotion& motion) {
  const Noise& noise = hardware_.noise;
  const double factor = robot_sample_.noise_of(ErrorCause::infrared);
  const double drift =
      robot_sample_.variation_of(ErrorCause::ambient) * hardware_.variation.ambient_drift * root_of_tick;
  for (std::size_t i = 0; i < infrared_.size(); ++i) {
    const Infrared& sensor = hardware_.sensors.infrared[i];
    InfraredState& state = infrared_[i];
    if (drift > 0.0) state.ambient = std::max(0.0, state.ambient + drift * normal(state.ambient_rng));
    if (factor > 0.0) state.noise = noise.infrared_memory * state.noise + fresh_ * normal(state.noise_rng);
    std::int16_t read = state.last;
    if (was_put_down_ || sense_.tick % groups_ == static_cast<unsigned>(sensor.group)) {
      double level = beams_.level(i, motion.position, motion.ahead) + state.ambient;
      level += factor * (noise.infrared + noise.infrared_share * level) * state.noise;
      read = state.last = in_register(std::min(std::max(level, 0.0), sensor.most));
    }
    // A mouse that was put down has stood there for a while.
    if (was_put_down_) std::fill(state.delayed.begin(), state.delayed.end(), read);
    if (!state.delayed.empty()) std::swap(read, state.delayed[sense_.tick % state.delayed.size()]);
    sense_.infrared[i] = read;
  }
  was_put_down_ = false;
}

void Senses::range(const BodyMotion& motion) {
  for (std::size_t i = 0; i < rangers_.size(); ++i) {
    const Ranger& ranger = hardware_.sensors.rangers[i];
    RangeSense& seen = sense_.ranges[i];
    seen.is_new = --rangers_[i].until_new <= 0;
    if (!seen.is_new) continue;
    rangers_[i].until_new = static_cast<int>(ranger.period);
    double distance = beams_.range(i, motion.position, motion.ahead);
    if (distance > 0.0) {
      constexpr double at_rest = 10.0;  // mm/s
      const bool moves = std::abs(motion.speed) > at_rest;
      const double deviation = moves ? hardware_.noise.ranger : hardware_.noise.ranger_rest;
      distance += robot_sample_.noise_of(ErrorCause::ranger) * deviation * normal(rangers_[i].rng);
    }
    seen.distance = static_cast<std::uint16_t>(std::clamp(distance + 0.5, 0.0, ranger.reach));
  }
}

}  // namespace labmouse
