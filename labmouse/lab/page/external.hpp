// Mice written by the user in the page: reads their names, and the contests that they have run.
#pragma once

#include <string>

#include "labmouse/lab/mice/contestant.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// The mouse described by the fields `name` and `spec`. `name` may be empty; `spec` is the SPEC with which the command
/// line would run the same program.
Contestant read_page_external(PageRequest& request);

/// The mice of the field `played`, if any, with the contests that they have run. Each needs one contest, with the right
/// seed, in each of the mazes.
std::vector<Contestant> read_played_mice(PageRequest& request, const std::vector<NamedMaze>& mazes,
                                         const RaceOrder& order);

}  // namespace labmouse
