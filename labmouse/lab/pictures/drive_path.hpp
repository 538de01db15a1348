// The path of a contest in seconds, point by point: dense enough to be drawn as lines, and to read times and speeds
// from.
#pragma once

#include <cstdint>
#include <vector>

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"
#include "labmouse/mouse/robot/drive_profile.hpp"

namespace labmouse {

/// A moment of a path. From here to the next point of the same run the acceleration is even.
struct DrivePathPoint {
  double time = 0.0;  ///< microseconds on the maze's clock
  double x = 0.0;     ///< in cells from the south-west corner
  double y = 0.0;
  double heading = 0.0;       ///< eighths of a turn clockwise from north; grows and falls beyond a whole turn
  double speed = 0.0;         ///< mm/s
  double acceleration = 0.0;  ///< mm/s² along the path, until the next point
};

/// Follows a mouse through a contest, run by run in the order of its record.
class DrivePath {
 public:
  /// At rest at its start; the model must outlive it.
  DrivePath(Pose start, const DriveModel& model) : model_(model), start_{start, true}, place_{start, true} {}

  /// The points of a run: where it begins, all of its moves or segments up to where it ends. `pace`: the part of the
  /// usual one at which it was driven.
  std::vector<DrivePathPoint> follow(const DriveRun& run, double pace = 1.0);
  /// Where the mouse is after the runs so far.
  const SearchPlace& place() const { return place_; }

 private:
  const DriveModel& model_;
  SearchPlace start_;
  SearchPlace place_;
};

/// The points of a route that begins at that time. A route in which it does not move has none.
std::vector<DrivePathPoint> path_of(const DriveRoute& route, MazeTime begin, const DriveModel& model);

}  // namespace labmouse
