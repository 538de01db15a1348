// The fields of the worlds in which robots drive.
#pragma once

#include "labmouse/lab/races/world.hpp"

namespace labmouse {

/// Of the world without errors.
const WorldFields& seconds_fields();
/// Of the worlds with errors: the physical world and the failure model.
const WorldFields& physical_fields();

}  // namespace labmouse
