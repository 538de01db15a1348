// module: strategies
// error: labmouse/contest/simulator.hpp: No such file|'labmouse/contest/simulator.hpp' file not found
//
// A strategy that would hold a contest of its own.
#include "labmouse/mouse/explorer.hpp"
#ifndef LABMOUSE_ALLOWED
#include "labmouse/contest/simulator.hpp"
#endif
