// Names that tell the races of one command apart.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// The name of the world's robot, printable; empty in a world without robots.
std::string robot_name(const World& world);

/// A name for each race: its world, and for several races in one world the conditions in which they differ, such as
/// "physical, kerise, noise 2".
std::vector<std::string> race_names(std::span<const Race> races);

}  // namespace labmouse
