// The world of mms on the list of all worlds.
#pragma once

#include "labmouse/lab/races/world_entry.hpp"

namespace labmouse {

extern const WorldEntry mms_entry;

}  // namespace labmouse
