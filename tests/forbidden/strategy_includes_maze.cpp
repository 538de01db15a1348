// module: strategies
// error: labmouse/maze/maze.hpp: No such file|'labmouse/maze/maze.hpp' file not found
//
// A strategy that would look at the truth.
#include "labmouse/mouse/explorer.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#ifndef LABMOUSE_ALLOWED
#include "labmouse/maze/maze.hpp"
#endif
