// room: contest
// error: labmouse/strategies/roster.hpp: No such file|'labmouse/strategies/roster.hpp' file not found
//
// A contest that treats one mouse unlike the others.
#include "labmouse/contest/simulator.hpp"
#ifndef LABMOUSE_ALLOWED
#include "labmouse/strategies/roster.hpp"
#endif
