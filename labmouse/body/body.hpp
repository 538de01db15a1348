// The simulated robot in a maze: how it moves under motor duties, and what its sensors read. This is its true state.
#pragma once

#include <cstdint>

#include "labmouse/body/beams.hpp"
#include "labmouse/body/contact.hpp"
#include "labmouse/body/error_scale.hpp"
#include "labmouse/body/field.hpp"
#include "labmouse/body/plant.hpp"
#include "labmouse/body/robot_sample.hpp"
#include "labmouse/body/senses.hpp"
#include "labmouse/hardware/sense.hpp"

namespace labmouse {

/// Contact with walls during a tick.
enum class Touch : std::uint8_t {
  none,
  graze,  ///< the first tick of a slow touch along a wall: it goes on, turned a little
  crash,  ///< the run is over
};

class Body {
 public:
  /// Maze and hardware must outlive it. All random numbers follow from the seed: those drawn once a contest, and those
  /// of each tick.
  Body(const Maze& maze, double cell, const Hardware& hardware, const ErrorScale& scale, std::uint64_t seed);
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  /// Puts it there at rest, with a random placement error (Variation::placement); angle in rad to the left of east.
  /// Calibrates the gyro.
  void put(const Position& position, double angle);
  /// The same in the middle of a cell.
  void put(Cell cell, Heading heading);
  void set_fan(bool on) { plant_.set_fan(on); }
  /// A tick; after a crash the mouse lies still until it is put somewhere.
  Touch step(const Drive& drive);

  const Sense& sense() const { return senses_.sense(); }
  const BodyMotion& motion() const { return plant_.motion(); }
  const RobotSample& robot_sample() const { return robot_sample_; }
  const Field& field() const { return field_; }
  bool crashed() const { return crashed_; }
  /// What it touched last.
  const Contact& contact() const { return contact_; }
  /// Whether the tyres were at their limit in one of the last `ticks` ticks.
  bool slid_within(int ticks) const { return since_slide_ < ticks; }

 private:
  Touch touch(const Contact& contact);

  const Hardware& hardware_;
  RobotSample robot_sample_;
  Field field_;
  Plant plant_;
  Senses senses_;
  Rng placement_rng_;
  bool crashed_ = false;
  bool grazing_ = false;
  Contact contact_;
  int since_slide_ = never;  ///< ticks
  static constexpr int never = 1 << 30;
};

}  // namespace labmouse
