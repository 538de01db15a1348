// What a mouse could do in a maze that it knows, in seconds.
#pragma once

#include <optional>

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/drive/robot.hpp"

namespace labmouse {

/// In microseconds; nothing where no route leads from the start in its direction to a goal.
struct DriveBound {
  /// The fastest route, from rest to the centre.
  std::optional<DriveTime> fastest;
  /// The best score by the rules, where a mouse drives fast only over walls that it has seen: that of the shortest search to
  /// a goal itself, or that of the fastest route after the shortest search to a goal and home.
  std::optional<MazeTime> score;
};

/// For a maze up to 32×32.
DriveBound drive_bound_of(const Maze& maze, const DriveRules& rules, const DriveModel& model);

/// The least time of a search from the start to a goal and on, to rest at the start again; nothing where there is no way.
std::optional<MazeTime> shortest_search_home(const Maze& maze, const SearchDrive& search);

/// The least time of a search to a goal by the clock of the rules; nothing where there is no way.
std::optional<MazeTime> shortest_search(const Maze& maze, const DriveRules& rules, const SearchDrive& search);

}  // namespace labmouse
