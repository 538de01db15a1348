#pragma once

#include "labmouse/lab/races/world_entry.hpp"

namespace labmouse {

extern const WorldEntry toy_entry;

}  // namespace labmouse
