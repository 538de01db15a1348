// Record of one contest in seconds: every move, wall and run, with times in microseconds since the first start.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/action.hpp"
#include "labmouse/mouse/pose.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

/// Microseconds since the mouse was first put into the maze.
using MazeTime = std::int64_t;

/// Converts a time.
/// @param time microseconds.
/// @return seconds.
constexpr double in_seconds(MazeTime time) { return static_cast<double>(time) / 1e6; }

/// A wall as it was first seen.
struct WallSeen {
  MazeTime time = 0;
  Wall wall;
  bool open = false;

  friend bool operator==(const WallSeen&, const WallSeen&) = default;
};

/// One move of a search. Between moves a mouse is at the edge by which it enters the cell of its pose, or at rest in
/// the middle of it.
struct SearchMove {
  MazeTime begin = 0;
  MazeTime end = 0;
  Pose from;
  Action action;  ///< rotation of 0, ±90 or 180 degrees, then so many cells ahead
  Pose to;
  bool replanned = false;  ///< whether the strategy planned a new route for it

  friend bool operator==(const SearchMove&, const SearchMove&) = default;
};

/// The dead ends of a maze, and how many of them a search saw before it entered a goal.
struct DeadEndCount {
  int seen = 0;
  int all = 0;
  int steps = 0;         ///< cells that it entered, each time counted
  int fewest_steps = 0;  ///< of the shortest way from the start to a goal

  friend bool operator==(const DeadEndCount&, const DeadEndCount&) = default;
};

/// One run of a contest: a search (which may go on behind the goal), the way home, a speed run over what is known, or
/// in a time trial a run of several laps.
struct DriveRun {
  /// The purpose of a run; see above.
  enum class Kind : std::uint8_t { search, home, speed, laps };

  Kind kind = Kind::search;
  MazeTime begin = 0;
  MazeTime end = 0;
  std::optional<MazeTime> gate_out;       ///< left the start cell
  std::optional<MazeTime> gate_in;        ///< first entered a goal; never in a run of laps
  std::optional<MazeTime> centre;         ///< first in the middle of a goal cell; never in a run of laps
  std::vector<MazeTime> laps;             ///< of a run of laps: when it left the start cell again, after each lap
  std::optional<DeadEndCount> dead_ends;  ///< of a search that entered a goal, if the rules count them
  bool touched = false;                   ///< whether the mouse had been touched in the maze before this run
  double pace = 1.0;                      ///< pace of the run, as a share of the usual one
  std::vector<SearchMove> moves;          ///< of a search and a way home
  DriveRoute route;                       ///< of a speed run or a run of laps; its times count from `begin`
  /// Walls known at the beginning, and the times of the fastest route over open walls and over walls not known to be
  /// closed; no_time if there is none.
  WallSet open;
  WallSet closed;
  DriveTime known = no_time;
  DriveTime possible = no_time;

  /// Whether it follows a route, not moves of a search.
  bool has_route() const { return kind == Kind::speed || kind == Kind::laps; }

  friend bool operator==(const DriveRun&, const DriveRun&) = default;
};

/// The name of a kind of run in records.
/// @param kind one of the four.
/// @return in static memory.
constexpr std::string_view name_of(DriveRun::Kind kind) {
  return kind == DriveRun::Kind::search  ? "search"
         : kind == DriveRun::Kind::home  ? "home"
         : kind == DriveRun::Kind::speed ? "speed"
                                         : "laps";
}

/// How a contest in seconds ended.
enum class DriveOutcome : std::uint8_t {
  finished,     ///< at least one run ended in a goal; in a time trial, at least one lap was completed
  out_of_time,  ///< none did within the time
  forfeit,      ///< the mouse gave up; `reason` says why
};

/// The name of an outcome, for records and tables.
/// @param outcome one of the three.
/// @return in static memory.
constexpr std::string_view name_of(DriveOutcome outcome) {
  return outcome == DriveOutcome::finished      ? "finished"
         : outcome == DriveOutcome::out_of_time ? "out of time"
                                                : "forfeit";
}

/// One contest of one mouse in one maze, in a world in seconds.
struct DriveRecord {
  std::vector<DriveRun> runs;
  std::vector<WallSeen> walls;
  DriveOutcome outcome = DriveOutcome::finished;
  ForfeitReason reason = ForfeitReason::none;
  /// Decisions of the strategy, and how many of them planned a new route.
  int decisions = 0;
  int replanned = 0;

  friend bool operator==(const DriveRecord&, const DriveRecord&) = default;
};

}  // namespace labmouse
