// The fields of the worlds in which robots drive.
#pragma once

#include "labmouse/lab/races/world.hpp"

namespace labmouse {

/// Of the world without errors.
const WorldFields& seconds_fields();
/// Of those in which things go wrong.
const WorldFields& physical_fields();

}  // namespace labmouse
