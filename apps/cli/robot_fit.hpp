// The commands of `labmouse robot` that use measurements.
#pragma once

#include "options.hpp"

namespace labmouse::cli {

/// Adds `fit` and `compare`, which run in Python because they need SciPy and matplotlib.
void add_robot_fit(Command& robot);

}  // namespace labmouse::cli
