// Mice that are programs of the page: their names, and the contests that they held.
#pragma once

#include <string>

#include "labmouse/lab/mice/contestant.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// The mouse in the fields `name`, which may be empty, and `spec`, under which its program would race on the command
/// line.
Contestant read_page_external(PageRequest& request);

/// The mice in the field `played`, if any, which race with the contests that they bring. Each brings one for each of
/// the mazes, with its seed.
std::vector<Contestant> read_played_mice(PageRequest& request, const std::vector<NamedMaze>& mazes,
                                         const RaceOrder& order);

}  // namespace labmouse
