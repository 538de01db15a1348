// Keys of a contest: texts of its world, mouse and maze, which with the seed determine its result.
#pragma once

#include <string>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// The key of a world: its name, edition, score formula, conditions and result fields.
std::string key_of(const World& world);
/// The conditions as a JSON object, which restore_world() reads.
std::string conditions_text(const World& world);

/// The key of a mouse. For a built-in mouse, it contains all parameters that matter in this world, the learned prior,
/// and the behaviour signature of this build. For an external mouse, it is its external_identity(). Empty for a mouse
/// that cannot be identified later.
std::string key_of(const World& world, const Contestant& mouse);

/// The key of a maze: the text of link_of() for it without a name, which has its walls, start, heading and goals.
std::string key_of(const Maze& maze);

}  // namespace labmouse
