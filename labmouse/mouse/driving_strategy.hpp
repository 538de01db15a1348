// The interface of a mouse in the worlds in seconds, where a controller drives it.
#pragma once

#include <cstdint>
#include <optional>

#include "labmouse/mouse/drive/search_motion.hpp"
#include "labmouse/mouse/log_odds_map.hpp"
#include "labmouse/mouse/strategy.hpp"

namespace labmouse {

/// A strategy that is driven. It decides while it searches; speed runs and ways home are driven for it.
class DrivingStrategy : public Strategy {
 public:
  /// The next action, in place of decide(), where the map is a log-odds map: known walls may change between two calls.
  /// `time`: microseconds since the contest began.
  virtual Action consider(const LogOddsMap& map, const SearchPlace& place, std::int64_t time) = 0;

  /// A reading in a pose in which it does not decide: in a cell that its last step passes, or on a way on which it is
  /// driven. Not with a log-odds map.
  virtual void show(const Pose& pose, const Sighting& seen) = 0;

  /// It stands at the start again, because it was carried there or because it found no route from there. `time`:
  /// microseconds since the contest began.
  virtual void carried(std::int64_t time) = 0;

  /// The share of the usual pace, up to 1, at which to drive the run that begins; `fast` if that is a speed run, and
  /// else a search run or a way home. Asked only in worlds with errors.
  virtual double pace(bool /*fast*/) { return 1.0; }

  /// From now on it searches at this share of the robot's pace, in place of that of its briefing.
  virtual void searches_at(double /*pace*/) {}

  /// The map that it asks for; nothing: that of the contest's conditions.
  virtual std::optional<MapKind> map_kind() const { return std::nullopt; }

  /// How often it has planned anew.
  virtual std::int64_t plans() const { return 0; }
};

}  // namespace labmouse
