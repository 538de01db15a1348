// Converts briefings and sensor readings to the C structures of labmouse_controller.h.
#pragma once

#include "labmouse/contest/controller_code.hpp"
#include "labmouse/hardware/labmouse_controller.h"

namespace labmouse {

labmouse_briefing briefing_in_c(const ControllerBriefing& briefing);
labmouse_sense sense_in_c(const Sense& sense);

}  // namespace labmouse
