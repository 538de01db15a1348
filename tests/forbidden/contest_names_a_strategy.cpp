// module: contest
// error: labmouse/strategies/builtin_mice.hpp: No such file|'labmouse/strategies/builtin_mice.hpp' file not found
//
// A contest that treats one mouse unlike the others.
#include "labmouse/contest/simulator.hpp"
#ifndef LABMOUSE_ALLOWED
#include "labmouse/strategies/builtin_mice.hpp"
#endif
