// Base of the drivers without a simulated body: it takes the times of moves from the robot's model.
#pragma once

#include "labmouse/contest/contest_driver.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

class TimedDriver : public ContestDriver {
 public:
  void put_at_start() override { place_ = {{maze_.start(), maze_.start_heading()}, true}; }

  const SearchPlace& place() const final { return place_; }
  MazeTime clock() const final { return clock_; }
  bool out_of_time() const final { return clock_ >= time_limit_; }

 protected:
  /// All must outlive it.
  TimedDriver(const Maze& maze, const DriveModel& model, MazeTime time_limit, DriveRecord& record)
      : maze_(maze), model_(model), time_limit_(time_limit), record_(record) {}

  /// A time at the usual pace, converted to the present pace.
  MazeTime slowed(MazeTime time) const { return at_pace(time, pace_); }
  MazeTime time_of(const Action& part) const;
  /// Makes a move that begins at that time, edge by edge. Writes the move and the passed gates into the last run.
  void advance(const Action& part, MazeTime begin, bool replanned);
  /// Called at the end of each edge, and at rest.
  virtual void arrive() {}
  /// Sets the place to the end of a route, at rest.
  void stand_behind(const DriveRoute& route);

  const Maze& maze_;
  const DriveModel& model_;
  MazeTime time_limit_;
  DriveRecord& record_;
  SearchPlace place_;
  MazeTime clock_ = 0;
  double pace_ = 1.0;
};

}  // namespace labmouse
