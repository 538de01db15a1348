// The world of steps on the list of all worlds.
#pragma once

#include "labmouse/lab/races/world_entry.hpp"

namespace labmouse {

extern const WorldEntry steps_entry;

}  // namespace labmouse
