// Several robots in the same mazes: is a change of the hardware worth it?
#pragma once

#include <span>
#include <string>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// A table for each set of races that differ only in their robots. For each mouse, it compares each robot with the
/// first one, maze by maze: the mean scores with failed contests at the limit, and the mean difference with its
/// interval and a verdict. Empty if no two races differ only in their robots. All races must have the same mice and
/// mazes.
std::string compare_robots(std::span<const Race> races);

}  // namespace labmouse
