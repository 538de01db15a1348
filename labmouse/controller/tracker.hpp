// Trajectory tracking: computes the commanded speed and turn rate from the target and the estimated pose.
//
// Method: dynamic feedback linearization (Oriolo, De Luca and Vendittelli, "WMR control via dynamic feedback
// linearization", IEEE Transactions on Control Systems Technology 10, 2002): the mouse is treated as a point with free
// acceleration, under PD control. That law is singular at rest, so slow mice use Samson's law (the same paper, section
// III).
#pragma once

#include "labmouse/controller/gains.hpp"
#include "labmouse/controller/target.hpp"

namespace labmouse {

/// Estimated position and direction of motion, which differs by the slip angle from where the mouse points.
struct Course {
  Position position;
  Direction way;
  double speed = 0.0;  ///< mm/s
};

/// Commanded motion.
struct Command {
  double speed = 0.0;     ///< mm/s
  double speeding = 0.0;  ///< mm/s²
  double turning = 0.0;   ///< rad/s
  double twisting = 0.0;  ///< rad/s²
};

class Tracker {
 public:
  explicit Tracker(const TrackerGains& gains) : gains_(gains) {}

  /// Call it before a start from rest.
  void reset() { speed_ = 0.0; }
  /// Returns the command for one tick.
  Command follow(const Target& target, const Course& course);

 private:
  Command follow_slowly(const Target& target, const Position& error, const Direction& off) const;

  TrackerGains gains_;
  double speed_ = 0.0;  ///< last commanded speed, mm/s
};

}  // namespace labmouse
