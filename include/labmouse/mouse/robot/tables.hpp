// The times of a robot's turns and straights, in whole microseconds: all that a planner needs.
//
// A turn begins where its curve does, which may be some mm after the node, in the direction of driving. The straight
// before it is longer by that length, the lead. Likewise the curve may end before the last node. A turn may come in
// several speeds. Turns that agree in speed and lead share a *lane*: the time of a straight follows from its length and
// the lanes at its two ends. There is one table for straights along the axes and one for diagonals.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "labmouse/mouse/robot/node.hpp"
#include "labmouse/mouse/robot/turn.hpp"

namespace labmouse {

/// A time in microseconds.
using DriveTime = std::int32_t;
/// The time of what cannot be driven. It is larger than any time of a route, and safe to add to another. All its bytes
/// are the same, so that memset can write it.
inline constexpr DriveTime no_time = 0x3f3f3f3f;

/// The speed and lead at which turns enter or leave straights.
struct Lane {
  double speed = 0.0;  ///< mm/s
  double lead = 0.0;   ///< mm between the node and where the curve begins or ends; a part of the straight

  friend bool operator==(const Lane&, const Lane&) = default;
};

/// One turn at one speed.
struct DrivenTurn {
  Turn turn = Turn::f45;
  std::uint8_t from = 0;   ///< lane in which it begins: of the straights before it
  std::uint8_t to = 0;     ///< lane in which it ends
  DriveTime time = 0;      ///< of the curve alone
  double speed = 0.0;      ///< mm/s where it begins
  double end_speed = 0.0;  ///< mm/s where it ends; it differs only for robots with grip
};

/// Straights of one kind: along the axes in half cells, or diagonal in half diagonals of a cell.
struct StraightTimes {
  /// The most units of a straight in a table.
  static constexpr int longest = 2 * max_drive_side;

  std::vector<Lane> lanes;
  /// The time of `units` between a turn that ends in lane `from` and one that begins in lane `to`: at
  /// [(units * lanes.size() + from) * lanes.size() + to], no_time where that cannot be driven; units 0 to longest.
  std::vector<DriveTime> between;

  /// Number of lanes.
  std::size_t count() const { return lanes.size(); }
  /// The time of a straight between two turns.
  /// @param units half cells or half diagonals, 0 to longest.
  /// @param from lane in which the turn before it ends.
  /// @param to lane in which the turn after it begins.
  /// @return microseconds; no_time if it cannot be driven.
  DriveTime at(int units, std::size_t from, std::size_t to) const {
    return between[(static_cast<std::size_t>(units) * count() + from) * count() + to];
  }
};

/// A robot as the planner sees it; make_drive_model() computes it.
struct DriveTables {
  double cell = 0.0;       ///< side of a cell, mm
  StraightTimes along;     ///< along the axes; a unit is half a cell
  StraightTimes diagonal;  ///< a unit is half a diagonal of a cell
  /// Times from rest at the start: over half cells from the middle of its cell to a lane, at [units * lanes + to].
  std::vector<DriveTime> start;
  /// Times to the end: over half cells from a lane to the middle of a goal cell, at
  /// [(room * lengths + units) * lanes + from]. `room` is the number of open cells beyond that one to stop in; more
  /// than rooms() - 1 count as that. There is only one value of `room` if a run may end at any speed.
  std::vector<DriveTime> finish;
  /// From the start to the end without a turn, at [room * lengths + units].
  std::vector<DriveTime> whole;
  /// All turns, by kind, the fastest of each first; those onto a diagonal and those back from it are both here.
  std::vector<DrivenTurn> turns;
  /// Hash of all numbers above, for records.
  std::uint64_t hash = 0;

  /// The time of the first straight: from rest at the start to a turn.
  /// @param units half cells from the middle of the start cell, 0 to StraightTimes::longest.
  /// @param lane of `along`, in which the turn begins.
  /// @return microseconds; no_time if it cannot be driven.
  DriveTime start_to(int units, std::size_t lane) const {
    return start[static_cast<std::size_t>(units) * along.count() + lane];
  }
  /// Number of values of `room`, at least 1. The tables must be filled.
  int rooms() const { return static_cast<int>(finish.size() / (lengths * along.count())); }
  /// The time of the last straight: from a turn to the middle of a goal cell.
  /// @param units half cells, 0 to StraightTimes::longest.
  /// @param lane of `along`, in which the turn ends.
  /// @param room open cells beyond the goal cell to stop in, 0 or more.
  /// @return microseconds; no_time if it cannot be driven, or the mouse could not stop in that room.
  DriveTime finish_from(int units, std::size_t lane, int room) const {
    return finish[place_of(units, room) * along.count() + lane];
  }
  /// The time of a run without a turn.
  /// @param units half cells from the middle of the start cell to that of a goal cell, 0 to StraightTimes::longest.
  /// @param room open cells beyond the goal cell to stop in, 0 or more.
  /// @return microseconds; no_time if the mouse could not stop in that room.
  DriveTime whole_way(int units, int room) const { return whole[place_of(units, room)]; }
  /// The least time of a turn's curve.
  /// @return microseconds; no_time without turns.
  DriveTime shortest_turn() const;

 private:
  static constexpr std::size_t lengths = StraightTimes::longest + 1;

  std::size_t place_of(int units, int room) const {
    return static_cast<std::size_t>(std::min(room, rooms() - 1)) * lengths + static_cast<std::size_t>(units);
  }
};

/// The hash of all numbers of the tables except `hash`, which is set to it. The same on every platform.
/// @param tables lengths count to the micrometre, speeds to the micrometre per second.
std::uint64_t hash_of(const DriveTables& tables);

}  // namespace labmouse
