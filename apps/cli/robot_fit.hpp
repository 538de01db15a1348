// The commands of `labmouse robot` that use measurements.
#pragma once

#include <string>

#include "options.hpp"

namespace labmouse::cli {

/// Adds `fit` and `compare`, which run in Python because they need SciPy and matplotlib.
void add_robot_fit(Command& robot);

/// The Python interpreter that runs them: the variable LABMOUSE_PYTHON names it; default: python3.
std::string python_of_fits();

}  // namespace labmouse::cli
