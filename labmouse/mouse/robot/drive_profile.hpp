// Where a mouse is at each moment of a route, and how fast.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/route.hpp"
#include "labmouse/mouse/robot/turn_drive.hpp"

namespace labmouse {

/// A point of a maze in mm from its south-west corner, and a direction in rad clockwise from north.
struct DriveSpot {
  double x = 0.0;
  double y = 0.0;
  double angle = 0.0;
};

/// One segment of a route, as it is driven. A straight, with the leads of the turns about it, speeds up, stays at the
/// limit and brakes. A turn is driven at one speed, or at changing ones if the robot has grip. Times are microseconds
/// since the segment's beginning, lengths mm from there.
class DriveProfile {
 public:
  DriveProfile(const DriveModel& model, const DriveRoute& route, std::size_t segment);

  double length() const { return length_; }
  DriveTime duration() const { return duration_; }
  /// Distance in mm from the segment's first node to its beginning, in the direction of driving: below 0 for a straight
  /// that begins before its node, above 0 for a turn that begins after it.
  double beginning() const { return shape_ != nullptr ? offset_ : -offset_; }
  /// The shape of a turn; null of a straight.
  const TurnShape* shape() const { return shape_; }

  /// The length driven at a time from 0 to duration().
  double distance_at(double time) const;
  /// mm/s at that time.
  double speed_at(double time) const;
  /// Of a straight, the two times at which the acceleration changes: when it no longer speeds up, and when it begins to
  /// brake. Of a turn its beginning and its end.
  std::array<double, 2> changes() const;
  /// The time at which a length from 0 to length() is driven.
  double time_at(double distance) const;
  /// Where the mouse is by then.
  DriveSpot spot(double distance) const;

 private:
  /// A piece in which the speed changes evenly.
  struct Phase {
    double seconds = 0.0;
    double length = 0.0;
    double speed = 0.0;  ///< at its beginning
    double acceleration = 0.0;
  };

  std::span<const Phase> phases() const { return std::span(phases_).first(phase_count_); }
  void add(const Phase& phase) { phases_[phase_count_++] = phase; }
  void set_straight(const DriveModel& model, const DriveRoute& route, std::size_t segment);
  void set_turn(const DriveModel& model, const DriveSegment& segment);
  void set_phases(const TurnDrive& drive);

  DriveSegment segment_;
  double cell_;
  double length_ = 0.0;
  double offset_ = 0.0;  ///< mm from the first node to the beginning: back for a straight, along the shape for a turn
  DriveTime duration_;
  double scale_ = 1e6;                          ///< microseconds per second of the phases: tables are rounded
  std::array<Phase, TurnDrive::steps> phases_;  ///< the first phase_count_ are in use; no heap
  std::size_t phase_count_ = 0;
  const TurnShape* shape_ = nullptr;
};

}  // namespace labmouse
