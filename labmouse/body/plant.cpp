#include "labmouse/body/plant.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/functions/exponential.hpp"
#include "labmouse/functions/normal.hpp"

namespace labmouse {
namespace {

/// What friction leaves of a duty.
double beyond_dead_zone(double duty, double dead_zone) { return duty - std::clamp(duty, -dead_zone, dead_zone); }

/// A motor at rest needs the dead zone to begin to move; one that moves loses it to friction, whatever its duty.
double effective(double duty, double rate, const MotorAxis& axis) {
  // Almost at rest it uses a mixture of both, so that the motor neither creeps nor chatters.
  constexpr double almost = 0.005;  // of what full duty gives
  const double moving = std::clamp(rate / (almost * axis.gain), -1.0, 1.0);
  return (1.0 - std::abs(moving)) * beyond_dead_zone(duty, axis.dead_zone) +
         (duty - moving * axis.dead_zone) * std::abs(moving);
}

double root_of_loss(double loss, double step) { return std::sqrt(loss * step); }

}  // namespace

Plant::Plant(const Field& field, const Hardware& hardware, const RobotSample& robot_sample, std::uint64_t seed)
    : field_(field), hardware_(hardware), robot_sample_(robot_sample), shaking_rng_(seed_for(seed, "shaking")) {
  drive_share_ = 1.0 - exp_of(-tick_seconds / hardware.motors.drive.time);
  turn_share_ = 1.0 - exp_of(-tick_seconds / hardware.motors.turn.time);
  const Noise& noise = hardware.noise;
  const double step = noise.shaking_pitch * tick_seconds;
  shaking_kick_ =
      2.0 * robot_sample.level(NoiseGroup::shaking) * noise.shaking * root_of_loss(noise.shaking_loss, step);
}

void Plant::put(const Position& position, double angle) {
  motion_ = {};
  motion_.position = position;
  motion_.angle = angle;
  motion_.ahead = direction_of(angle);
  shaking_ = shaking_rate_ = 0.0;
  voltage_ = 1.0;
}

void Plant::stop() {
  motion_.speed = motion_.turning = motion_.yaw = motion_.slip = motion_.speeding = motion_.sideways = 0.0;
  shaking_ = shaking_rate_ = 0.0;
}

void Plant::step(const Drive& drive) {
  const double before = motion_.speed;
  drive_motors(drive);
  shake();
  slide(before);
  move();
}

void Plant::drive_motors(const Drive& drive) {
  const Motors& motors = hardware_.motors;
  const double left = std::clamp(static_cast<double>(drive.left), -1.0, 1.0);
  const double right = std::clamp(static_cast<double>(drive.right), -1.0, 1.0);
  voltage_ = 1.0 - motors.sag * (std::abs(left) + std::abs(right)) / 2.0;
  const double pushed_left = left * robot_sample_.motor[0] * voltage_,
               pushed_right = right * robot_sample_.motor[1] * voltage_;
  const double loss = std::clamp(motion_.speed, -1.0, 1.0) * motors.turning * std::abs(motion_.turning);
  const double onwards = effective((pushed_left + pushed_right) / 2.0, motion_.speed, motors.drive) - loss;
  const double around = effective(pushed_right - pushed_left, motion_.turning, motors.turn);
  motion_.speed += drive_share_ * (motors.drive.gain * onwards - motion_.speed);
  motion_.turning += turn_share_ * (motors.turn.gain * around - motion_.turning);
}

void Plant::shake() {
  const Noise& noise = hardware_.noise;
  const double step = noise.shaking_pitch * tick_seconds;
  if (shaking_kick_ > 0.0) {
    shaking_rate_ += -step * shaking_ - 2.0 * noise.shaking_loss * step * shaking_rate_ +
                     shaking_kick_ * NormalNumber::of(shaking_rng_.bits());
    shaking_ += step * shaking_rate_;
  }
  const double strength = std::min(1.0, std::abs(motion_.speed) / noise.shaking_speed);
  motion_.yaw = motion_.turning + strength * shaking_;
}

/// Limits the acceleration to the grip, and updates the slip and the lateral acceleration that the tyres give.
void Plant::slide(double before) {
  motion_.speeding = (motion_.speed - before) / tick_seconds;
  const double grip = hardware_.tyres.grip * robot_sample_.grip;
  const double stiffness = hardware_.tyres.stiffness * robot_sample_.stiffness;
  if (std::abs(motion_.speeding) > grip) {
    motion_.speeding = motion_.speeding > 0.0 ? grip : -grip;
    motion_.speed = before + motion_.speeding * tick_seconds;
  }
  // The slip equations divide by the speed, so it is at least this.
  constexpr double slow = 20.0;  // mm/s
  const double speed = std::max(std::abs(motion_.speed), slow);
  const double most = std::sqrt(std::max(0.0, grip * grip - motion_.speeding * motion_.speeding));
  const double held = (motion_.slip - motion_.yaw * tick_seconds) * speed / (speed + stiffness * tick_seconds);
  slides_ = std::abs(stiffness * held) > most;
  if (!slides_) {
    motion_.slip = held;
    motion_.sideways = -stiffness * held;
  } else {
    motion_.sideways = held > 0.0 ? -most : most;
    motion_.slip += (motion_.sideways / speed - motion_.yaw) * tick_seconds;
  }
  motion_.slip = std::clamp(motion_.slip, -0.5, 0.5);
}

void Plant::move() {
  const Position from = motion_.position;
  const double turn = motion_.yaw * tick_seconds, way = motion_.speed * tick_seconds;
  const Direction goes = turned_by(motion_.ahead, turn / 2.0 + motion_.slip);
  motion_.position = {from.x + way * goes.cosine, from.y + way * goes.sine};
  motion_.ahead = turned_by(motion_.ahead, turn);
  motion_.angle += turn;
  cross(from);
}

/// Applies the floor's step at a boundary that was just crossed.
void Plant::cross(const Position& from) {
  const Cell before = field_.cell_at(from), after = field_.cell_at(motion_.position);
  if (before == after || !field_.contains(before)) return;
  const Heading heading = after.x > before.x   ? Heading::east
                          : after.x < before.x ? Heading::west
                          : after.y > before.y ? Heading::north
                                               : Heading::south;
  const bool there = heading == Heading::north || heading == Heading::east;
  const FloorStep step = robot_sample_.floor_step(wall_at(before, heading));
  // In the opposite direction, both signs are reversed.
  const double turn = there ? step.turn : -step.turn, shift = there ? step.shift : -step.shift;
  motion_.position = {motion_.position.x - shift * motion_.ahead.sine,
                      motion_.position.y + shift * motion_.ahead.cosine};
  motion_.ahead = turned_by(motion_.ahead, turn);
  motion_.angle += turn;
}

void Plant::graze(const Position& position, double turn, double speed_kept) {
  motion_.position = position;
  motion_.ahead = turned_by(motion_.ahead, turn);
  motion_.angle += turn;
  motion_.speed *= speed_kept;
  motion_.slip = 0.0;
}

}  // namespace labmouse
