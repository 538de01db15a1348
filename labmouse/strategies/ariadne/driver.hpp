// ariadne in the world of seconds.
//
// Method: to the goal by the least search time, where every unseen wall on the way costs something more, by how likely
// it is closed. Afterwards as certify does, to the nearest unseen wall of the fastest route that may exist. Where the
// time in the maze counts, that is one through walls that are likely enough to be open, and the mouse goes to look only
// while the look pays: while what the route would save, times the chance that all of its walls are open, is more than
// the detour divided by the divisor of the rules. Then it goes home as flood-return does, and looks about on the way.
// Where the time in the maze does not count it proves its route.
#pragma once

#include <memory>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/strategy.hpp"
#include "labmouse/mouse/wall_prior.hpp"

namespace labmouse::ariadne {

/// For a briefing in seconds; without a prior every unseen wall is as likely open as closed.
std::unique_ptr<Strategy> make_driver(const Briefing& briefing, const WallPrior* prior);

}  // namespace labmouse::ariadne
