// The commands of `labmouse robot` that begin with what was measured.
#pragma once

#include "options.hpp"

namespace labmouse::cli {

/// Adds `fit` and `compare`.
void add_robot_fit(Command& robot, int& exit);

}  // namespace labmouse::cli
