// The built-in priors of walls, as counted by `labmouse learn`.
#pragma once

#include <array>

#include "labmouse/mouse/wall_prior.hpp"

namespace labmouse {

/// Counted in real contest mazes of 16×16 cells; contest.prior says how many, docs/research/priors.md which.
extern const WallPrior contest_prior;
/// Counted in mazes without loops, as `labmouse make depth-first` makes them; docs/research/priors.md says which.
extern const WallPrior loop_free_prior;

/// The default prior for a maze of that size. Null for mazes of less than 8 cells on a side: there the border and the
/// goal are always near, and it misleads.
const WallPrior* contest_prior_for(Size size);

/// A reluctance is -ln P(open) in units of 1/32 nat.
inline constexpr int reluctance_a_nat = 32;
/// Larger values would claim more certainty than the counts support.
inline constexpr int most_reluctance = 112;

/// -ln P(closed) in units of 1/32 nat, for a reluctance from 1 to most_reluctance.
int complement(int reluctance);

}  // namespace labmouse
