// The physical world on the list of all worlds.
#pragma once

#include "labmouse/lab/races/world_entry.hpp"

namespace labmouse {

extern const WorldEntry physical_entry;

}  // namespace labmouse
