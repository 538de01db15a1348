// room: strategies
// error: labmouse/maze/maze.hpp: No such file|'labmouse/maze/maze.hpp' file not found
//
// A mind that would look at the truth.
#include "labmouse/mouse/explorer.hpp"
#include "labmouse/strategies/roster.hpp"
#ifndef LABMOUSE_ALLOWED
#include "labmouse/maze/maze.hpp"
#endif
