// A route in seconds: straights, diagonals and turns.
#pragma once

#include <vector>

#include "labmouse/mouse/pose.hpp"
#include "labmouse/mouse/robot/tables.hpp"

namespace labmouse {

/// One piece of a route, from node to node.
struct DriveSegment {
  /// What is driven: straight on, or a curve.
  enum class Kind : std::uint8_t { straight, turn };

  Kind kind = Kind::straight;
  DriveNode from;
  DriveNode to;
  DriveTime begin = 0;     ///< microseconds since the run's start
  DriveTime end = 0;       ///< microseconds since the run's start
  int units = 0;           ///< of a straight: half cells, or half diagonals where its nodes are diagonal ones
  std::uint16_t turn = 0;  ///< of a turn: its place in DriveTables::turns
  bool left = false;       ///< of a turn: the side it turns to

  /// Whether it is a straight along a diagonal; false for all turns.
  bool diagonal() const { return kind == Kind::straight && from.diagonal(); }

  friend bool operator==(const DriveSegment&, const DriveSegment&) = default;
};

/// A route from rest in the middle of a start cell to the middle of a goal cell, at a speed that the robot may have
/// there. Straights and turns alternate; a straight of no length is left out, unless there is a lead to drive.
struct DriveRoute {
  std::vector<DriveSegment> segments;
  DriveTime time = no_time;  ///< microseconds of the whole; no_time if there is no route

  friend bool operator==(const DriveRoute&, const DriveRoute&) = default;
};

/// Follows a route segment by segment, to find where it ends and how much room it needs to stop.
class RouteEnd {
 public:
  /// Goes to the end of the next segment.
  /// @param segment begins at the end of the last one; copied.
  void pass(const DriveSegment& segment);
  /// The node at the end of the last segment.
  /// @pre A segment has passed.
  const DriveNode& node() const { return last_.to; }
  /// Number of open cells beyond the end that the mouse needs to stop in. The route must be one that can be driven.
  /// @param tables those that it was planned with.
  /// @return cells; 0 if no segment has passed.
  int room(const DriveTables& tables) const;

 private:
  bool empty_ = true;
  DriveSegment last_;
  int turn_ = none;  ///< the last one
  static constexpr int none = -1;
};

/// Number of open cells beyond its end that a route needs to stop in.
/// @param route one that can be driven.
/// @param tables those that it was planned with.
/// @return cells; 0 for a route without segments.
int stopping_room(const DriveRoute& route, const DriveTables& tables);

}  // namespace labmouse
