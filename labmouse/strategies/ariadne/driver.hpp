// ariadne in the world of seconds.
//
// Method: go to the goal by the least search time over all walls not known to be closed. Turns count as cheap, because
// corners show more of a maze. What follows depends on the rules.
//
// If the maze time counts, the mouse goes home on the way with the least cost: search time, plus the price of unseen
// walls (the likelier closed, the higher), minus the worth of unseen cells. A cell is worth the gain of the best run
// through it over the best known one, times the probability that all walls of that run are open (RunCosts).
//
// If it does not count, the mouse explores like certify: it goes to the next unseen wall of the fastest possible route,
// until such a route would save next to nothing. Only walls likely enough to be open are considered, and ways past
// cells worth a look are preferred. In mazes of more than 256 cells, it considers all walls, until its route is proven
// to be the fastest; its ways lead through unseen cells if there is time for all of them. Turns count as cheap only
// early, because a mouse that comes late to the goal may have no time for a run.
#pragma once

#include <memory>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/driving_strategy.hpp"
#include "labmouse/mouse/wall_prior.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse::ariadne {

/// The strategy for a briefing in seconds, with the settings of DrivePolicy. Without a prior every unseen wall is open
/// with probability 1/2.
std::unique_ptr<DrivingStrategy> make_driver(const Briefing& briefing, const Settings& settings,
                                             const WallPrior* prior);

}  // namespace labmouse::ariadne
