// From where a mouse should be and where it believes to be to how fast it has to drive and turn.
//
// Method: dynamic feedback linearization (Oriolo, De Luca and Vendittelli, "WMR control via dynamic feedback
// linearization", IEEE Transactions on Control Systems Technology 10, 2002): seen as a point whose acceleration is
// chosen freely, the mouse follows by a proportional and a derivative term. At rest that law has no meaning; slow mice
// follow a law of Samson's (the same paper, section III).
#pragma once

#include "labmouse/controller/gains.hpp"
#include "labmouse/controller/target.hpp"

namespace labmouse {

/// Where a mouse believes to be, and where it goes: its way may differ from where it points, by its slip.
struct Course {
  Position position;
  Direction way;
  double speed = 0.0;  ///< mm/s
};

/// How it has to move.
struct Command {
  double speed = 0.0;     ///< mm/s
  double speeding = 0.0;  ///< mm/s²
  double turning = 0.0;   ///< rad/s
  double twisting = 0.0;  ///< rad/s²
};

class Tracker {
 public:
  explicit Tracker(const TrackerGains& gains) : gains_(gains) {}

  /// Forgets; before it begins from rest.
  void reset() { speed_ = 0.0; }
  /// One tick.
  Command follow(const Target& target, const Course& course);

 private:
  Command follow_slowly(const Target& target, const Position& error, const Direction& off) const;

  TrackerGains gains_;
  double speed_ = 0.0;  ///< that it was told last
};

}  // namespace labmouse
