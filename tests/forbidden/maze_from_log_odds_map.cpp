// module: contest
// error: no matching (function for call to|constructor for initialization of|conversion for functional-style cast).*Maze
//
// What a mouse believes is not a maze.
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {

Maze believed(const Knowledge& knowledge) {
#ifdef LABMOUSE_ALLOWED
  return Maze(MazeDraft(knowledge.size(), MazeDraft::Inside::open));
#else
  return Maze(knowledge);
#endif
}

}  // namespace labmouse
