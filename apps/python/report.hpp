// Makes the HTML page that shows a race or a contest, for notebooks.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "labmouse/lab/races/race.hpp"

namespace labmouse::python {

/// One HTML file with the race and the records of these contests. Throws UserError if the package was built without
/// the page.
std::string report_of(const Race& race, const std::vector<std::pair<ContestResult, ContestOutput>>& contests);

}  // namespace labmouse::python
