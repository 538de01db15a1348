// module: contest
// error: no matching (function for call to|constructor for initialization of|conversion for functional-style cast).*Knowledge
//
// Knowledge told wall by wall, past any reading.
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {

Knowledge told(const Maze& maze) {
#ifdef LABMOUSE_ALLOWED
  return Knowledge(maze.size());
#else
  return Knowledge(maze.size(), maze.open_walls());
#endif
}

}  // namespace labmouse
