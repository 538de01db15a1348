// Where a turn is driven: between which nodes, and among which walls.
#pragma once

#include <vector>

#include "labmouse/grid/wall.hpp"
#include "labmouse/mouse/robot/node.hpp"
#include "labmouse/mouse/robot/turn_shape.hpp"

namespace labmouse {

/// A turn to the left somewhere in a maze.
struct TurnRoom {
  DriveNode from;
  DriveNode to;
  std::vector<Wall> open;      ///< must be open
  std::vector<Wall> standing;  ///< all others of the cells about it: may stand; posts are their ends
};

/// Of a turn back from a diagonal: that of the turn onto it, which it passes from `to` to `from`.
TurnRoom room_of(Turn turn);

/// A point in cells from the south-west corner of a maze.
struct MazePoint {
  double x = 0.0;
  double y = 0.0;
};

/// Where a point of a turn from that node lies; of a turn to the left, or of its mirror image to the right.
MazePoint maze_point(const DriveNode& from, bool left, const PathPoint& point, double cell);

/// Distance in mm between the path of a turn and the nearest post or wall that may stand, middle to middle.
double clearance_of(const TurnShape& shape, double cell);

}  // namespace labmouse
