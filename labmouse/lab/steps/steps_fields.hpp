// The fields and columns of a race in steps. docs/reference/results.md describes them.
#pragma once

#include "labmouse/lab/races/world.hpp"

namespace labmouse {

const WorldFields& steps_fields();

}  // namespace labmouse
