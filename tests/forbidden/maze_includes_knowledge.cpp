// module: maze
// error: labmouse/mouse/knowledge.hpp: No such file|'labmouse/mouse/knowledge.hpp' file not found
//
// Truth that depends on belief.
#include "labmouse/maze/maze.hpp"
#ifndef LABMOUSE_ALLOWED
#include "labmouse/mouse/knowledge.hpp"
#endif
