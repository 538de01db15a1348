// The fields and columns of a race in the physical world. docs/physical.md describes them.
#pragma once

#include "labmouse/lab/races/world.hpp"

namespace labmouse {

const WorldFields& physical_fields();

}  // namespace labmouse
