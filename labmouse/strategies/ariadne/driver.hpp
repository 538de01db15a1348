// ariadne in the world of seconds.
//
// Method: to the goal by the least search time over all that may be open, with turns counted as cheap: corners show
// more of a maze. What follows depends on the rules.
//
// Where the time in the maze counts, the mouse goes home by the least sum of search time and of what unseen walls cost
// by how likely they are closed, less what unseen cells are worth: what the best run through one would gain over the
// best known one, by the chance that all of its walls are open (RunCosts).
//
// Where it does not count, the mouse goes on as certify does, to the next unseen wall of the fastest route that may
// exist, over walls that are likely enough to be open and past cells that are worth a look, until such a route would
// save next to nothing. In mazes larger than those that the prior was learned from it hopes for all walls, and proves;
// its ways to the next wall lead through unseen cells, if there is time for them. Turns count as cheap only early: a
// mouse that comes to the goal late may not run in time.
#pragma once

#include <memory>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/driving_strategy.hpp"
#include "labmouse/mouse/wall_prior.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse::ariadne {

/// For a briefing in seconds, with the settings that DrivePolicy reads; without a prior every unseen wall is as likely
/// open as closed.
std::unique_ptr<DrivingStrategy> make_driver(const Briefing& briefing, const Settings& settings,
                                             const WallPrior* prior);

}  // namespace labmouse::ariadne
