// One millisecond of a drive in the physical world, as a log has it.
#pragma once

#include "labmouse/body/plant.hpp"
#include "labmouse/hardware/sense.hpp"

namespace labmouse {

/// The readings, the duties that follow, and the true motion at the time of the readings.
struct LoggedTick {
  Sense sense;
  Drive drive;
  BodyMotion motion;
};

}  // namespace labmouse
