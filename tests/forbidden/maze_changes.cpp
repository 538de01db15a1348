// module: maze
// error: (class|in) .*Maze.* has no member named|no member named 'open' in 'labmouse::Maze'
//
// A maze is final: walls open in a draft only.
#include "labmouse/maze/maze.hpp"

namespace labmouse {

#ifdef LABMOUSE_ALLOWED
using Target = MazeDraft;
#else
using Target = Maze;
#endif

void dig(Target& maze) { maze.open({0, 0}, Heading::north); }

}  // namespace labmouse
