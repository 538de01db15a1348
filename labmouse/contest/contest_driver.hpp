// The moving part of a contest in which things go wrong: what takes a mouse from place to place, or not.
#pragma once

#include "labmouse/contest/believed_walls.hpp"
#include "labmouse/contest/drive_record.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"

namespace labmouse {

/// Drives, and writes what happens into a record, whose last run it is part of.
class ContestDriver {
 public:
  virtual ~ContestDriver() = default;

  /// A hand puts the mouse at the start.
  virtual void put_at_start() = 0;
  /// Stands there, and reads the walls.
  virtual void look_about() = 0;
  /// A move of a search over one edge, a dash, or to rest, and what is read at its end; false where the run broke off.
  virtual bool make(const Action& part, bool replanned) = 0;
  /// A fast run from the start, and until the mouse stands; false where it broke off.
  virtual bool run(const DriveRoute& route) = 0;
  virtual void wait(MazeTime time) = 0;
  /// From now on it drives at that part of its usual pace.
  virtual void set_pace(double pace) = 0;

  /// Where the mouse believes to be, between two moves.
  virtual const SearchPlace& place() const = 0;
  /// What it takes walls for.
  virtual BelievedWalls& walls() = 0;
  virtual MazeTime clock() const = 0;
  virtual bool out_of_time() const = 0;
  virtual bool crashed() const = 0;
  /// Of a crash.
  virtual RunEnd cause() const = 0;
};

}  // namespace labmouse
