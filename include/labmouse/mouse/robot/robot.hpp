// A robot: the limits of a real mouse, from which its turns and times follow.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "labmouse/hardware/hardware.hpp"
#include "labmouse/mouse/robot/tables.hpp"
#include "labmouse/mouse/robot/yaw_ramp.hpp"

namespace labmouse {

/// The times of a robot's search moves, in microseconds. It drives cell by cell at one speed, and reads the walls of
/// each cell as it enters it.
struct SearchDrive {
  DriveTime cell = 0;       ///< straight on, from edge to edge
  DriveTime turn = 0;       ///< a quarter turn inside one cell, from edge to edge
  DriveTime back = 0;       ///< stops in the middle of the cell, pivots, and leaves it where it came in
  DriveTime quarter = 0;    ///< a quarter turn on the spot, at rest
  DriveTime half_cell = 0;  ///< from rest in the middle of a cell to its edge, or from there to rest
  /// The time from an edge over so many half cells straight on, accelerating, through known cells: the first half of a
  /// dash, whose second half is as long. All 0 if known cells are driven as others are.
  std::array<DriveTime, max_drive_side + 1> onward{};

  /// Whether it accelerates over known cells.
  bool dashes() const { return onward.back() != 0; }
  /// The time of a dash: straight on over some edges, where the walls of all cells between them are known.
  /// @param cells number of edges, 0 to max_drive_side.
  /// @return microseconds at the full pace.
  DriveTime dash(int cells) const {
    return cells < 2 || !dashes() ? cells * cell : 2 * onward[static_cast<std::size_t>(cells)];
  }
  /// The time of a dash from its beginning to one of its edges.
  /// @param cells number of edges of the dash, 0 to max_drive_side.
  /// @param edge number of edges up to there, 0 to `cells`.
  /// @return microseconds at the full pace.
  DriveTime dash_part(int cells, int edge) const {
    if (cells < 2 || !dashes()) return edge * cell;
    const auto half = [&](int edges) { return onward[static_cast<std::size_t>(2 * edges)]; };
    return 2 * edge <= cells ? half(edge) : dash(cells) - half(cells - edge);
  }

  friend bool operator==(const SearchDrive&, const SearchDrive&) = default;
};

/// Published times of a robot, where its limits are not known: one speed at all nodes, and the whole time of each turn
/// from node to node.
struct FixedTimes {
  double speed = 0.0;  ///< mm/s at every node
  /// Microseconds by turn; a turn back from a diagonal takes as long as that onto it.
  DriveTime f45 = 0, f90 = 0, f135 = 0, f180 = 0, v90 = 0, s90 = 0;
};

/// How one kind of turn is driven, where the file says more than the limits do.
struct TurnLayout {
  bool driven = true;  ///< whether the robot drives this turn
  /// The speed in mm/s that its path is laid out for; for a 180 the straights before and after it in mm, as published.
  /// 0: what fits best.
  double given = 0.0;

  friend bool operator==(const TurnLayout&, const TurnLayout&) = default;
};

/// Where a run may end. `goal`: at rest in the middle of the goal cell, or of one of the open cells straight beyond it,
/// so that it must be able to stop from its speed in the goal. `beyond`: at any speed, as if there were no wall beyond
/// the goal.
enum class Stop : std::uint8_t { goal, beyond };

/// The most speeds that each turn may have.
inline constexpr int most_speeds = 8;

/// A robot as its file describes it. Lengths are in mm, times in seconds, angles in rad.
struct Robot {
  std::string name;
  double cell = 180.0;                                     ///< side of a cell
  double speed = 0.0, speed_diagonal = 0.0;                ///< mm/s, limits on straights
  double acceleration = 0.0, acceleration_diagonal = 0.0;  ///< mm/s²
  double braking = 0.0, braking_diagonal = 0.0;            ///< mm/s², positive
  double lateral_acceleration = 0.0;                       ///< mm/s², in curves
  double yaw_acceleration = 0.0;                           ///< rad/s², where a curve begins and ends
  double yaw_speed = 0.0;                                  ///< rad/s; 0: as much as the lateral acceleration allows
  double yaw_jerk = 0.0;                                   ///< rad/s³; 0: no limit
  TurnProfile profile = TurnProfile::trapezoid;            ///< how curves begin and end
  double grip = 0.0;          ///< mm/s², lateral and longitudinal together; 0: turns are driven at one speed each
  double clearance = 0.0;     ///< mm that the robot's middle keeps from the middle of any post and wall that may stand
  double run_up = 0.0;        ///< mm behind the middle of the start cell where it stands before a run
  int speeds = 6;             ///< of each turn at most, 1 to most_speeds: its own largest, and lower ones
  Stop stop = Stop::goal;     ///< of robots with limits; those of published times end at the speed of the nodes
  int sight = 1;              ///< cells that its sensors see in each direction
  bool diagonals = true;      ///< whether it drives diagonals
  double search_speed = 0.0;  ///< mm/s
  double search_turn_speed = 0.0;    ///< mm/s, on its own path; 0: at the search speed, on the path of S90
  double known_speed = 0.0;          ///< mm/s, of a search over known cells; 0: as over others
  double known_acceleration = 0.0;   ///< mm/s², there; 0: the lesser of acceleration and braking
  double pivot_speed = 0.0;          ///< rad/s, turning on the spot
  double pivot_acceleration = 0.0;   ///< rad/s²
  SearchDrive search;                ///< if its `cell` is 0, it is computed from the numbers above
  std::optional<FixedTimes> fixed;   ///< if given, the limits of curves above are not used
  std::optional<Hardware> hardware;  ///< what it is built of, where that is known
  /// By Turn. A turn back from a diagonal has the layout of the turn onto it. S90 is always driven, since it is enough
  /// for every maze.
  std::array<TurnLayout, all_turns.size()> layouts{};

  /// The layout of a turn.
  /// @param turn one of all_turns.
  /// @return part of this robot; for a turn back from a diagonal that of the turn onto it.
  const TurnLayout& layout(Turn turn) const {
    const bool back = begins_diagonal(turn) && !ends_diagonal(turn);
    return layouts[static_cast<unsigned>(back ? reversed(turn) : turn)];
  }
  /// Whether the robot drives a turn: if its layout says so, and for turns to or from diagonals if it drives diagonals.
  /// @param turn one of all_turns.
  bool drives(Turn turn) const {
    return layout(turn).driven && (diagonals || !(begins_diagonal(turn) || ends_diagonal(turn)));
  }
};

}  // namespace labmouse
