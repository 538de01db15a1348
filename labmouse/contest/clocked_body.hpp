// The simulated body of a mouse in a contest, with the clock. It records wall touches, the trace, and when the mouse
// passes the gates (out of the start cell, into a goal).
#pragma once

#include <cstdint>

#include "labmouse/body/body.hpp"
#include "labmouse/contest/logged_tick.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// Writes what it touches, and its trace, into the record.
class ClockedBody {
 public:
  /// All must outlive it.
  ClockedBody(const Maze& maze, const DriveModel& model, const PhysicalConditions& conditions, std::uint64_t seed,
              MazeTime time_limit, PhysicalRecord& record);

  /// Places the mouse at the start, by hand.
  void set_fan(bool on) { body_.set_fan(on); }
  void put_at_start() { body_.put(maze_.start(), maze_.start_heading()); }
  /// Simulates one tick; false after a crash, and at the end of the time.
  bool step(const Drive& duties);
  void wait(MazeTime time) { clock_ += time; }
  /// Records the gates that the true mouse has passed in that run.
  void note_gates(DriveRun& run);
  /// Records a trace point if one is due: the true pose, and the estimated pose if there is one.
  void trace(const std::optional<BodyPose>& estimate);
  bool trace_due() const;

  const Sense& sense() const { return body_.sense(); }
  const Body& body() const { return body_; }
  MazeTime clock() const { return clock_; }
  bool out_of_time() const { return clock_ >= time_limit_; }
  bool crashed() const { return body_.crashed(); }
  /// Cause of a crash: the tyres slid, or else the position was lost.
  RunEnd cause() const;
  /// The cell of the true mouse, which may lie outside of the maze.
  Cell cell() const { return body_.field().cell_at(body_.motion().position); }

 private:
  void note_laps(DriveRun& run, Cell cell);
  BodyPose pose() const { return {body_.motion().position, body_.motion().angle}; }

  const Maze& maze_;
  double cell_;
  int trace_every_;
  std::vector<LoggedTick>* log_;  ///< null: no log
  MazeTime time_limit_;
  PhysicalRecord& record_;
  Body body_;
  MazeTime clock_ = 0;
  bool in_start_ = false;  ///< whether the true mouse was in the start cell at the last tick of a run of laps
};

}  // namespace labmouse
