// The priors that come with labmouse: what `labmouse learn` counted.
#pragma once

#include <array>

#include "labmouse/mouse/wall_prior.hpp"

namespace labmouse {

/// Of real contest mazes of 16×16 cells; contest.prior says how many, docs/research/priors.md which.
extern const WallPrior contest_prior;
/// Of mazes without loops, as `labmouse make depth-first` makes them; docs/research/priors.md says which.
extern const WallPrior loop_free_prior;

/// The default prior for a maze of that size, or null: in mazes smaller than half of those that it was counted in, the
/// border and the goal are everywhere, and it misleads.
const WallPrior* contest_prior_for(Size size);

/// A reluctance is -ln P(open) in 1/32.
inline constexpr int reluctance_a_nat = 32;
/// What is more is surer than anything that was counted.
inline constexpr int most_reluctance = 112;

/// -ln P(closed) in 1/32 for a reluctance from 1 to most_reluctance.
int complement(int reluctance);

}  // namespace labmouse
