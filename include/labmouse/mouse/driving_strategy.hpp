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
  /// Called in place of decide() with a log-odds map, where known walls may change between two calls. Returns the next
  /// action. `time`: microseconds since the contest began.
  virtual Action consider(const LogOddsMap& map, const SearchPlace& place, std::int64_t time) = 0;

  /// Reports a reading in a pose where it does not decide: in a cell that its last step passes, or on a way that is
  /// driven for it. Not called with a log-odds map.
  virtual void show(const Pose& pose, const Sighting& seen) = 0;

  /// It stands at the start again: it was carried there, or could not leave because its map has no route. `time`:
  /// microseconds since the contest began.
  virtual void carried(std::int64_t time) = 0;

  /// The share of the usual pace, up to 1, for the run that begins: a speed run if `fast`, else a search run or a way
  /// home. Called only in worlds with errors.
  virtual double pace(bool /*fast*/) { return 1.0; }

  /// Sets the share of the robot's pace at which it searches from now on, in place of that of its briefing.
  virtual void searches_at(double /*pace*/) {}

  /// The kind of map that it requires; nothing: that of the contest's conditions.
  virtual std::optional<MapKind> map_kind() const { return std::nullopt; }

  /// Number of times that it has planned anew.
  virtual std::int64_t plans() const { return 0; }
};

}  // namespace labmouse
