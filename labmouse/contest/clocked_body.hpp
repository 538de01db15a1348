// A body in a contest: its clock, the gates that it passes, what it touches, and the trace of it.
#pragma once

#include <cstdint>

#include "labmouse/body/body.hpp"
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

  /// A hand puts it at the start.
  void put_at_start() { body_.put(maze_.start(), maze_.start_heading()); }
  /// A tick; false after a crash, and at the end of the time.
  bool step(const Drive& duties);
  void wait(MazeTime time) { clock_ += time; }
  /// Where the true mouse is, for the clock of that run.
  void note_gates(DriveRun& run) const;
  /// A point of the trace, where one is due: where the mouse is, and where it believes to be, if that is known.
  void trace(const std::optional<BodyPose>& estimate);
  bool trace_due() const;

  const Sense& sense() const { return body_.sense(); }
  const Body& body() const { return body_; }
  MazeTime clock() const { return clock_; }
  bool out_of_time() const { return clock_ >= time_limit_; }
  bool crashed() const { return body_.crashed(); }
  /// Of a crash: whether its tyres did not hold, or it was elsewhere than it should be.
  RunEnd cause() const;
  /// The cell in which the true mouse is; outside of the maze one that lies outside.
  Cell cell() const { return body_.field().cell_at(body_.motion().position); }

 private:
  BodyPose pose() const { return {body_.motion().position, body_.motion().angle}; }

  const Maze& maze_;
  double cell_;
  int trace_every_;
  MazeTime time_limit_;
  PhysicalRecord& record_;
  Body body_;
  MazeTime clock_ = 0;
};

}  // namespace labmouse
