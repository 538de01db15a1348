// Lower bounds of times in the world of seconds, for a mouse that knows the maze.
#pragma once

#include <optional>

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// Lower bounds for a maze, in microseconds.
struct DriveBound {
  /// Time of the fastest route from rest at the start to the goal's centre; empty where no route from the start pose
  /// reaches a goal. Where laps count: time of the fastest lap.
  std::optional<DriveTime> fastest;
  /// The score of a mouse that knows the maze but may start a speed run only after a search run. It is the lower of two
  /// scores: that of the shortest search run to a goal alone; and that of the fastest route, driven after the shortest
  /// search run to a goal and back. With gate-to-gate timing it is not strict: the fastest route is chosen from rest to
  /// the centre, and another one may be some milliseconds faster between the gates. Where laps count, it is the fastest
  /// lap of a route (see lap_route()) without errors. Empty where no run is valid.
  std::optional<MazeTime> score;
};

/// The bounds of a maze of at most 32×32 cells.
DriveBound drive_bound_of(const Maze& maze, const DriveRules& rules, const DriveModel& model);

/// The least time, in microseconds, of a search run from the start to a goal and back to rest at the start. On the way
/// back all cells count as known. Empty where there is no route.
std::optional<MazeTime> shortest_search_home(const Maze& maze, const SearchDrive& search);

/// The least time of a search run to a goal, in microseconds, timed by the rules. Empty where there is no route, or it
/// exceeds the time limit.
std::optional<MazeTime> shortest_search(const Maze& maze, const DriveRules& rules, const SearchDrive& search);

}  // namespace labmouse
