// module: maze
// error: discards qualifiers|no viable overloaded|no viable operator|not marked const
//
// A maze is final: its walls can be read, not taken away.
#include "labmouse/maze/maze.hpp"

namespace labmouse {

void raze(Maze& maze) {
#ifdef LABMOUSE_ALLOWED
  WallSet walls = maze.open_walls();
  walls |= WallSet::all(maze.size());
#else
  maze.open_walls() |= WallSet::all(maze.size());
#endif
}

}  // namespace labmouse
