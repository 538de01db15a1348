// What determines a contest, as texts: the world, the mouse and the maze, besides the seed.
#pragma once

#include <string>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// The name of a world, how it scores, its conditions, and what its results look like.
std::string key_of(const World& world);
/// The conditions as an object of JSON, as restore_world reads it.
std::string conditions_text(const World& world);

/// A mouse of ours with all parameters that count in this world, what it has learned, and the behaviour signature of
/// this build; an external mouse as external_identity says it. Empty for a mouse of which nothing is known that could
/// be compared.
std::string key_of(const World& world, const Contestant& mouse);

/// The maze as a link without a name: its walls, start and goals.
std::string key_of(const Maze& maze);

}  // namespace labmouse
