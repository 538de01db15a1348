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
  Pose pose;
  bool at_rest = false;

  friend constexpr bool operator==(const SearchPlace&, const SearchPlace&) = default;
};

/// Whether a step is one of those above, and not one that does nothing.
bool is_search_step(const SearchPlace& from, const Action& step);

/// Where such a step leads, if all walls on its way are open.
SearchPlace after_search(const SearchPlace& from, const Action& step);

/// The time of such a step, with dashes over the cells of `known`.
DriveTime search_time(const SearchDrive& drive, const SearchPlace& from, const Action& step, const CellSet& known = {});

/// Number of edges, 1 to `most`, over which the mouse dashes from an edge: as far as it need not read a cell.
template <class Knows>
int dash_length(const SearchDrive& drive, const Pose& edge, int most, Knows knows) {
  int cells = 1;
  if (drive.dashes())
    while (cells < most && knows(neighbour(edge.cell, edge.heading, cells))) ++cells;
  return cells;
}

/// The time in microseconds, at a share of the pace, of what takes `time` at the full pace.
inline std::int64_t at_pace(std::int64_t time, double pace) {
  return pace == 1.0 ? time : static_cast<std::int64_t>(static_cast<double>(time) / pace);
}

/// The step over `cells` edges in a direction.
Action search_step(Heading heading, Heading direction, int cells);

}  // namespace labmouse
