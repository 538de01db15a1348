#include "labmouse/body/plant.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/functions/exponential.hpp"
#include "labmouse/functions/normal.hpp"
#include "labmouse/hardware/motor_driver.hpp"

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
    : field_(field),
      hardware_(hardware),
      robot_sample_(robot_sample),
      shaking_rng_(seed_for(seed, "shaking")),
      charge_(robot_sample.battery),
      voltage_(charge_) {
  drive_share_ = 1.0 - exp_of(-tick_seconds / hardware.motors.drive.time);
  turn_share_ = 1.0 - exp_of(-tick_seconds / hardware.motors.turn.time);
  const Noise& noise = hardware.noise;
  const double step = noise.shaking_pitch * tick_seconds;
  shaking_kick_ =
      2.0 * robot_sample.noise_of(ErrorCause::shaking) * noise.shaking * root_of_loss(noise.shaking_loss, step);
}

void Plant::put(const Position& position, double angle) {
  motion_ = {};
  motion_.position = position;
  motion_.angle = angle;
  motion_.ahead = direction_of(angle);
  shaking_ = shaking_rate_ = 0.0;
  voltage_ = charge_;
}

void Plant::stop() {
  motion_.speed = motion_.rolling = motion_.turning = motion_.yaw = motion_.slip = motion_.speeding = motion_.sideways =
      0.0;
  shaking_ = shaking_rate_ = 0.0;
}

void Plant::step(const Drive& drive) {
  const double rolled = motion_.rolling;
  const Floor floor = robot_sample_.floor(field_.cell_at(motion_.position));
  const Direction& ahead = motion_.ahead;
  constexpr double gravity = 9810.0;  // mm/s²
  motion_.pull = {-gravity * (floor.slope.x * ahead.cosine + floor.slope.y * ahead.sine),
                  -gravity * (floor.slope.y * ahead.cosine - floor.slope.x * ahead.sine)};
  drive_motors(drive);
  roll(rolled, grip(floor));
  shake();
  slide(grip(floor));
  move();
}

void Plant::drive_motors(const Drive& drive) {
  const Motors& motors = hardware_.motors;
  const double left = std::clamp(static_cast<double>(drive.left), -1.0, 1.0);
  const double right = std::clamp(static_cast<double>(drive.right), -1.0, 1.0);
  const double both = (std::abs(left) + std::abs(right)) / 2.0;
  charge_ = std::max(0.0, charge_ - motors.discharge * both * tick_seconds);
  voltage_ = charge_ * (1.0 - motors.sag * both);
  const auto pushed = [&](Wheel wheel, double duty) {
    return braked_duty(motors, duty, motors.strength[wheel] * robot_sample_.motor[wheel], voltage_,
                       idle_duty(motors, wheel, motion_.rolling, motion_.turning));
  };
  const double pushed_left = pushed(left_wheel, left), pushed_right = pushed(right_wheel, right);
  const double loss = std::clamp(motion_.speed, -1.0, 1.0) * motors.turning * std::abs(motion_.turning);
  const double onwards = effective((pushed_left + pushed_right) / 2.0, motion_.rolling, motors.drive) - loss;
  const double around = effective(pushed_right - pushed_left, motion_.turning, motors.turn);
  motion_.rolling += drive_share_ * (motors.drive.gain * onwards - motion_.rolling);
  motion_.turning += turn_share_ * (motors.turn.gain * around - motion_.turning) -
                     hardware_.tyres.yaw_moment * motion_.sideways * tick_seconds;
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

double Plant::grip(const Floor& floor) const {
  const Tyres& tyres = hardware_.tyres;
  return (tyres.grip * robot_sample_.grip + (fan_ ? tyres.downforce : 0.0)) * floor.grip;
}

/// Accelerates the mouse by what the tyres hold of the motors' torque. Wheels that spin keep the rest: it turns their
/// own share of the inertia. `rolled`: their speed before the motors.
void Plant::roll(double rolled, double grip) {
  const double before = motion_.speed, asked = (motion_.rolling - rolled) / tick_seconds;
  const double ahead = rolled - before;  // of the mouse, where they spin
  if (ahead == 0.0 && std::abs(asked) <= grip) {
    motion_.speed = motion_.rolling;
  } else {
    const double force = (ahead != 0.0 ? ahead : asked) > 0.0 ? grip : -grip;
    motion_.speed = before + force * tick_seconds;
    const double rotating = hardware_.motors.rotating;
    if (rotating > 0.0) motion_.rolling = rolled + (asked - (1.0 - rotating) * force) / rotating * tick_seconds;
    // They roll as soon as they are no longer faster than the mouse, or no longer slower.
    if (rotating <= 0.0 || (motion_.rolling - motion_.speed) * force <= 0.0) motion_.rolling = motion_.speed;
  }
  // A mouse at rest stands on a slope.
  constexpr double creeping = 20.0;  // mm/s
  const double pulled = motion_.pull.x * std::min(1.0, std::abs(motion_.speed) / creeping) * tick_seconds;
  motion_.speed += pulled;
  motion_.rolling += pulled;
  motion_.speeding = (motion_.speed - before) / tick_seconds;
}

/// Updates the slip and the lateral acceleration that the tyres give.
void Plant::slide(double grip) {
  const double stiffness = hardware_.tyres.stiffness * robot_sample_.stiffness;
  // The slip equations divide by the speed, so it is at least this.
  constexpr double slow = 20.0;  // mm/s
  const double speed = std::max(std::abs(motion_.speed), slow);
  const double most = std::sqrt(std::max(0.0, grip * grip - motion_.speeding * motion_.speeding));
  const double pulled = motion_.pull.y * std::min(1.0, std::abs(motion_.speed) / slow) / speed;
  const double held =
      (motion_.slip + (pulled - motion_.yaw) * tick_seconds) * speed / (speed + stiffness * tick_seconds);
  slides_ = std::abs(stiffness * held) > most;
  if (!slides_) {
    motion_.slip = held;
    motion_.sideways = -stiffness * held;
  } else {
    motion_.sideways = held > 0.0 ? -most : most;
    motion_.slip += (motion_.sideways / speed + pulled - motion_.yaw) * tick_seconds;
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
  motion_.rolling = motion_.speed;
  motion_.slip = 0.0;
}

}  // namespace labmouse
