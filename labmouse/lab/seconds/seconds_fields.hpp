// The fields and columns of a race in seconds. docs/seconds.md describes them.
#pragma once

#include "labmouse/lab/races/world.hpp"

namespace labmouse {

const WorldFields& seconds_fields();

}  // namespace labmouse
