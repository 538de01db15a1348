// The page with a race in it, for notebooks.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "labmouse/lab/races/race.hpp"

namespace labmouse::python {

/// One HTML file with the race and the records of these contests of it. Throws UserError where the package has no page.
std::string report_of(const Race& race, const std::vector<std::pair<ContestResult, ContestOutput>>& contests);

}  // namespace labmouse::python
