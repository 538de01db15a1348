// module: contest
// error: no matching (function for call to|constructor for initialization of|conversion for functional-style cast).*Knowledge
//
// Knowledge that was not seen: the one place where both truth and belief are at hand is the contest.
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {

Knowledge born_wise(const Maze& maze) {
#ifdef LABMOUSE_ALLOWED
  return Knowledge(maze.size());
#else
  return Knowledge(maze);
#endif
}

}  // namespace labmouse
