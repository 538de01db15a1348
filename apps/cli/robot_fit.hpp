// The commands of `labmouse robot` that begin with what was measured.
#pragma once

#include "options.hpp"

namespace labmouse::cli {

/// Adds `fit` and `compare`, which Python does: there are SciPy and matplotlib.
void add_robot_fit(Command& robot);

}  // namespace labmouse::cli
