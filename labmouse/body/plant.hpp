// How a mouse moves: motors and battery, wheelspin, slip, shaking and the floor, a tick at a time.
//
// Method: forward motion and turning are each a first-order motor with a dead zone. Where the motors ask for more than
// the tyres hold, the wheels spin: what is left of the torque turns them faster. The lateral force of the tyres grows
// with the slip angle, up to a friction circle that is shared with acceleration and braking; it acts behind the centre
// of mass, and so turns the mouse back. Shaking is a resonance driven by noise. docs/explanation/physical-model.md has
// the equations, and where each number comes from.
#pragma once

#include <array>
#include <cstdint>

#include "labmouse/body/field.hpp"
#include "labmouse/body/robot_sample.hpp"
#include "labmouse/chance/rng.hpp"
#include "labmouse/functions/angles.hpp"
#include "labmouse/hardware/sense.hpp"

namespace labmouse {

/// Where a mouse is and how it moves. Angles are to the left; directions are measured from east.
struct BodyMotion {
  Position position;      ///< of the middle of the axle
  Direction ahead;        ///< where the body points
  double angle = 0.0;     ///< the same in rad, not wrapped to one turn
  double speed = 0.0;     ///< mm/s
  double rolling = 0.0;   ///< mm/s of the wheels' rims, the mean of both; differs from the speed where they spin
  double turning = 0.0;   ///< rad/s by the motors
  double yaw = 0.0;       ///< rad/s of the body, with shaking
  double slip = 0.0;      ///< slip angle, rad from where it points to where it goes
  double speeding = 0.0;  ///< mm/s² ahead
  double sideways = 0.0;  ///< mm/s² to the left, by the tyres
  Position pull;          ///< mm/s² of gravity ahead and to the left, on a floor that is not level
};

class Plant {
 public:
  /// All must outlive it.
  Plant(const Field& field, const Hardware& hardware, const RobotSample& robot_sample, std::uint64_t seed);

  /// Puts it at rest, in that position and direction.
  void put(const Position& position, double angle);
  /// Advances by a tick under these duties.
  void step(const Drive& drive);
  const BodyMotion& motion() const { return motion_; }
  /// The battery's voltage as a share of that of the full battery at rest.
  double voltage() const { return voltage_; }
  /// Switches the fan.
  void set_fan(bool on) { fan_ = on; }
  /// Whether its tyres are at their limit, so that it slides outwards.
  bool slides() const { return slides_; }
  /// A graze: moves the mouse out of what it touches, turns it, and keeps this share of its speed.
  void graze(const Position& position, double turn, double speed_kept);
  void stop();

 private:
  void drive_motors(const Drive& drive);
  /// What the tyres hold on the floor of this cell, mm/s².
  double grip(const Floor& floor) const;
  void roll(double rolled, double grip);
  void shake();
  void slide(double grip);
  void move();
  void cross(const Position& from);

  const Field& field_;
  const Hardware& hardware_;
  const RobotSample& robot_sample_;
  BodyMotion motion_;
  double drive_share_ = 0.0, turn_share_ = 0.0;  ///< share of the way to its steady speed that a motor makes in a tick
  Rng shaking_rng_;
  double shaking_ = 0.0, shaking_rate_ = 0.0;  ///< of the resonance, rad/s
  double shaking_kick_ = 0.0;
  double charge_, voltage_;  ///< of the battery at rest and now, as shares of the full battery at rest
  bool fan_ = false;
  bool slides_ = false;
};

}  // namespace labmouse
