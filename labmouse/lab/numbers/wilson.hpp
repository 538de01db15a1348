// The interval of a share.
#pragma once

#include "labmouse/lab/numbers/statistics.hpp"

namespace labmouse {

/// 95 % interval of a share by its score (Wilson 1927): sound for few trials, and where all or none succeeded. From 0
/// to 1 without any trial.
Interval wilson_interval(int successes, int trials);

}  // namespace labmouse
