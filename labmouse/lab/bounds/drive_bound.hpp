// What a mouse could do in a maze that it knows, in seconds.
#pragma once

#include <optional>

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// In microseconds.
struct DriveBound {
  /// The fastest route, from rest to the centre; nothing where none leads from the start in its direction to a goal.
  std::optional<DriveTime> fastest;
  /// The score by the rules, in their time, of a mouse that knows the maze but drives fast only over walls that it has
  /// seen: of the shortest search to a goal itself, or of the fastest route after the shortest search to a goal and
  /// home. By the clock from gate to gate another route may be faster by some milliseconds. Nothing where no run can
  /// count.
  std::optional<MazeTime> score;
};

/// For a maze up to 32×32.
DriveBound drive_bound_of(const Maze& maze, const DriveRules& rules, const DriveModel& model);

/// The least time of a search from the start to a goal and on, to rest at the start again, where all cells are known
/// once a goal was entered; nothing where there is no way.
std::optional<MazeTime> shortest_search_home(const Maze& maze, const SearchDrive& search);

/// The least time of a search to a goal by the clock of the rules; nothing where there is no way, or it takes too long.
std::optional<MazeTime> shortest_search(const Maze& maze, const DriveRules& rules, const SearchDrive& search);

}  // namespace labmouse
