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
  std::vector<Wall> standing;  ///< other walls about its cells, which may stand; posts are their ends
};

/// The walls of a turn. A turn back from a diagonal has those of the turn onto it, which it passes from `to` to `from`.
TurnRoom room_of(Turn turn);

/// A point in cells from the south-west corner of a maze.
struct MazePoint {
  double x = 0.0;
  double y = 0.0;
};

/// The position of a point of a turn that begins at that node: to the left, or mirrored to the right.
MazePoint maze_point(const DriveNode& from, bool left, const PathPoint& point, double cell);

/// The distance from a point to a wall between its posts, in cells.
double distance(MazePoint point, Wall wall);

/// Distance in mm between the path of a turn and the nearest post or wall that may stand, middle to middle.
double clearance_of(const TurnShape& shape, double cell);

}  // namespace labmouse
