// The world of seconds on the list of all worlds.
#pragma once

#include "labmouse/lab/races/world_entry.hpp"

namespace labmouse {

extern const WorldEntry seconds_entry;

}  // namespace labmouse
