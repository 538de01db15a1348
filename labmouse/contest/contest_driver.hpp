// Interface of the driver in a contest in seconds: it moves the mouse as the strategy decides, or fails to.
#pragma once

#include <optional>

#include "labmouse/contest/believed_walls.hpp"
#include "labmouse/contest/drive_record.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"

namespace labmouse {

/// Drives the mouse, and writes the moves into the last run of a record.
class ContestDriver {
 public:
  virtual ~ContestDriver() = default;

  /// Whether it can crash and detect walls wrongly. If not, it drives only at the usual pace, and reads at all edges.
  virtual bool errs() const = 0;

  /// Places the mouse at the start, by hand.
  virtual void put_at_start() = 0;
  /// Carries the mouse there by hand during a contest, which may take time.
  virtual void carry_to_start() = 0;
  /// Marks walls as open that are known before the contest.
  virtual void know_open(const WallSet& walls) = 0;
  /// Reads the walls at rest.
  virtual void look_about() = 0;
  /// Makes a search move: over one edge, over several known cells (a dash), or to rest. Reads at its end; false if the
  /// run was aborted.
  virtual bool make(const Action& part, bool replanned) = 0;
  /// Makes a speed run or a run of laps from the start until the mouse stands; false if the run was aborted.
  virtual bool run(const DriveRoute& route) = 0;
  /// Sets the pace, as a share of the usual one.
  virtual void set_pace(double pace) = 0;

  /// The believed place, between two moves.
  virtual const SearchPlace& place() const = 0;
  /// The believed walls.
  virtual const Knowledge& known() const = 0;
  /// The walls around a pose that the mouse has been in, as the strategy gets them.
  virtual Sighting seen(const Pose& pose) const = 0;
  /// The map, if it combines contradicting readings, so that walls can change; null if the first reading of a wall
  /// stays.
  virtual BelievedWalls* weighed() = 0;
  virtual MazeTime clock() const = 0;
  virtual bool out_of_time() const = 0;
  /// The cause of a crash since the mouse was last put at the start, if there was one.
  virtual std::optional<RunEnd> crash() const = 0;
};

}  // namespace labmouse
