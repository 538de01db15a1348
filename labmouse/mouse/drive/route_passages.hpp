// The passages that matter to the routes from a start to the goals: all but those in dead ends.
#pragma once

#include "labmouse/grid/wall_set.hpp"

namespace labmouse {

/// Leaves out the passages that lead into dead ends. No route turns back, so all routes that are possible over the
/// passages, and the room that they need to stop beyond a goal, are in what is left.
/// @param size of the maze.
/// @param passages the open walls, all inside the size.
/// @param start the cell where routes begin.
/// @param goals the cells where they may end.
/// @return some of these passages: of fewer passages at most as many.
WallSet passages_of_routes(Size size, WallSet passages, Cell start, const CellSet& goals);

}  // namespace labmouse
