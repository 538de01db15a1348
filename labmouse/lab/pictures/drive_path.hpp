// The path of a contest in seconds as points, dense enough for drawings and for times and speeds at any place.
#pragma once

#include <cstdint>
#include <vector>

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"
#include "labmouse/mouse/robot/drive_profile.hpp"

namespace labmouse {

/// A point of a path. The acceleration is constant up to the next point of the same run.
struct DrivePathPoint {
  double time = 0.0;  ///< microseconds on the maze's clock
  double x = 0.0;     ///< in cells from the south-west corner
  double y = 0.0;
  double heading = 0.0;       ///< eighths of a turn clockwise from north; not wrapped to one turn
  double speed = 0.0;         ///< mm/s
  double acceleration = 0.0;  ///< mm/s² along the path, until the next point
};

/// Computes the path of a mouse in a contest. Call follow() for each run in the order of the record.
class DrivePath {
 public:
  /// Begins at rest at the start; the model must outlive this object.
  DrivePath(Pose start, const DriveModel& model) : model_(model), start_{start, true}, place_{start, true} {}

  /// The points of a run, from its begin to its end.
  /// @param pace Speed of the run relative to the model's, for example 0.9.
  std::vector<DrivePathPoint> follow(const DriveRun& run, double pace = 1.0);
  /// The place of the mouse after the runs so far.
  const SearchPlace& place() const { return place_; }

 private:
  const DriveModel& model_;
  SearchPlace start_;
  SearchPlace place_;
};

/// The points of a route that begins at that time, in microseconds; empty for a route without segments.
std::vector<DrivePathPoint> path_of(const DriveRoute& route, MazeTime begin, const DriveModel& model);

}  // namespace labmouse
