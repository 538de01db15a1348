// Keys of a contest: texts of its world, mouse and maze, which with the seed determine its result.
#pragma once

#include <string>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// The key of a world: its name, edition, score formula, conditions and result fields.
std::string key_of(const World& world);
/// The conditions as a JSON object, which restore_world() reads.
std::string conditions_text(const World& world);

/// The key of a mouse. A built-in mouse has all parameters that matter in this world, its learned prior, and the
/// behaviour signature of this build; an external mouse has its external_identity. Empty for a mouse that cannot be
/// compared later.
std::string key_of(const World& world, const Contestant& mouse);

/// The key of a maze: its link without a name, with walls, start and goals.
std::string key_of(const Maze& maze);

}  // namespace labmouse
