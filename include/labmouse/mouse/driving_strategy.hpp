// The interface of a mouse in the worlds in seconds, whose scores are times, and where a controller drives the mouse.
#pragma once

#include <cstdint>
#include <optional>

#include "labmouse/mouse/drive/search_motion.hpp"
#include "labmouse/mouse/log_odds_map.hpp"
#include "labmouse/mouse/strategy.hpp"

namespace labmouse {

/// A strategy in the worlds in seconds. It decides while it searches; speed runs and ways home are driven for it.
class DrivingStrategy : public Strategy {
 public:
  /// Decides with a log-odds map, whose known walls may change between two calls. Called in place of decide().
  /// @param map the log-odds of all walls; map.version() has grown if a known wall has changed.
  /// @param place where the next action begins: the estimated place of the mouse, or after a speed run the start.
  /// @param time microseconds since the contest began.
  /// @return as decide(). A forfeit with `no_route` does not end the contest at once: some closed walls of the map are
  ///   made unknown, and it is called again.
  virtual Action consider(const LogOddsMap& map, const SearchPlace& place, std::int64_t time) = 0;

  /// Reports a reading in a pose where it does not decide: in a cell that its last step passes, or on a way that is
  /// driven for it. Not called with a log-odds map.
  /// @param pose where the walls were read.
  /// @param seen in cells, from that pose.
  virtual void show(const Pose& pose, const Sighting& seen) = 0;

  /// Reports that the mouse stands at the start again: it was carried there, or could not leave because its map has no
  /// route.
  /// @param time microseconds since the contest began.
  virtual void carried(std::int64_t time) = 0;

  /// Chooses the pace of the run that begins: a speed run if the argument is true, else a search run or a way home.
  /// Called only in worlds with errors.
  /// @return share of the usual pace; the contest cuts it to 0.2 to 1.
  virtual double pace(bool /*fast*/) { return 1.0; }

  /// Sets the pace at which it searches from now on, in place of that of its briefing. The argument is a share of the
  /// robot's pace, greater than 0.
  virtual void searches_at(double /*pace*/) {}

  /// The kind of map that it requires.
  /// @return nullopt: that of the contest's conditions.
  virtual std::optional<MapKind> map_kind() const { return std::nullopt; }

  /// Number of times that it has planned anew.
  virtual std::int64_t plans() const { return 0; }
};

}  // namespace labmouse
