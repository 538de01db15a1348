// How a mouse searches in the worlds in seconds: cell by cell, over edges (the boundaries between cells).
//
// Between two moves it is at the edge by which it enters a cell, heading into it, and has just read the walls of that
// cell; or at rest in the middle of a cell, as it is in the beginning. An Action::step(rotation, cells) of it is
//
//       0, k   straight on over k edges
//     ±90, k   a small turn, then straight on
//     180, k   stops in the middle, pivots, leaves where it came in, then straight on
//     any, 0   stops in the middle, pivots, and looks
//
// The first of the k edges is that by which it leaves its cell. At rest, a rotation is a pivot. Straight on over known
// cells is a dash, if the robot drives them: there is nothing to be read before its end.
#pragma once

#include <cstdint>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/action.hpp"
#include "labmouse/mouse/pose.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// Where a searching mouse is between two moves.
struct SearchPlace {
  Pose pose;             ///< the cell that it enters or stands in, and its heading
  bool at_rest = false;  ///< whether it stands in the middle of the cell

  friend constexpr bool operator==(const SearchPlace&, const SearchPlace&) = default;
};

/// Whether an action is one of the steps above, and not one that does nothing.
/// @param from where it begins.
/// @param step any action.
/// @return false also for a movement below 0 or above max_drive_side cells.
bool is_search_step(const SearchPlace& from, const Action& step);

/// Where such a step leads, if all walls on its way are open.
/// @param from where it begins.
/// @param step one that is_search_step() accepts.
/// @return outside the maze, if the step leads there.
SearchPlace after_search(const SearchPlace& from, const Action& step);

/// The time of such a step at the full pace.
/// @param drive the moves of the robot.
/// @param from where it begins.
/// @param step one that is_search_step() accepts.
/// @param known cells whose walls are all known: the robot dashes over them.
/// @return microseconds.
DriveTime search_time(const SearchDrive& drive, const SearchPlace& from, const Action& step, const CellSet& known = {});

/// Number of edges over which the mouse dashes from an edge: as far as it need not read a cell.
/// @param drive the moves of the robot.
/// @param edge the edge by which it enters that cell, in that heading.
/// @param most the largest result, at least 1.
/// @param knows called with cells ahead: whether all walls of a cell are known.
/// @return 1 to `most`; 1 if the robot does not dash.
template <class Knows>
int dash_length(const SearchDrive& drive, const Pose& edge, int most, Knows knows) {
  int cells = 1;
  if (drive.dashes())
    while (cells < most && knows(neighbour(edge.cell, edge.heading, cells))) ++cells;
  return cells;
}

/// Scales a time to a pace.
/// @param time microseconds at the full pace.
/// @param pace share of the full pace, greater than 0.
/// @return microseconds at that pace, rounded down.
inline std::int64_t at_pace(std::int64_t time, double pace) {
  return pace == 1.0 ? time : static_cast<std::int64_t>(static_cast<double>(time) / pace);
}

/// The step in a direction of the maze.
/// @param heading that of the mouse before the step.
/// @param direction where to drive.
/// @param cells edges to pass; 0: only turns, and rests.
Action search_step(Heading heading, Heading direction, int cells);

}  // namespace labmouse
