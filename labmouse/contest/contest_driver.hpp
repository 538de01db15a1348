// The moving part of a contest in seconds: what takes a mouse from place to place, or fails to.
#pragma once

#include <optional>

#include "labmouse/contest/believed_walls.hpp"
#include "labmouse/contest/drive_record.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"

namespace labmouse {

/// Drives, and writes what happens into a record, whose last run it is part of.
class ContestDriver {
 public:
  virtual ~ContestDriver() = default;

  /// Whether it can detect walls wrongly and crash. One that cannot drives at the usual pace alone, and reads at all
  /// edges.
  virtual bool errs() const = 0;

  /// A hand puts the mouse at the start.
  virtual void put_at_start() = 0;
  /// A hand carries it there in the middle of a contest, which may take some time.
  virtual void carry_to_start() = 0;
  /// Stands there, and reads the walls.
  virtual void look_about() = 0;
  /// A move of a search over one edge, a dash, or to rest, and what is read at its end; false where the run broke off.
  virtual bool make(const Action& part, bool replanned) = 0;
  /// A speed run from the start, and until the mouse stands; false where it broke off.
  virtual bool run(const DriveRoute& route) = 0;
  /// From now on it drives at that part of its usual pace.
  virtual void set_pace(double pace) = 0;

  /// Where the mouse believes to be, between two moves.
  virtual const SearchPlace& place() const = 0;
  /// What it takes walls for.
  virtual const Knowledge& known() const = 0;
  /// What it tells the mouse of the walls about a pose that it has been in.
  virtual Sighting seen(const Pose& pose) const = 0;
  /// Its map, where that weighs readings and may change its strategy; null where walls stay what they were first read
  /// as.
  virtual BelievedWalls* weighed() = 0;
  virtual MazeTime clock() const = 0;
  virtual bool out_of_time() const = 0;
  /// The cause of a crash; nothing where the mouse has not crashed since it was last put at the start.
  virtual std::optional<RunEnd> crash() const = 0;
};

}  // namespace labmouse
