// The fields and columns of a race of programs written for mms. docs/reference/results.md describes them.
#pragma once

#include "labmouse/lab/races/world.hpp"

namespace labmouse {

const WorldFields& mms_fields();

}  // namespace labmouse
