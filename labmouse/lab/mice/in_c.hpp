// The briefing and the senses of controllers in C, in the structures of their header.
#pragma once

#include "labmouse/contest/controller_code.hpp"
#include "labmouse/hardware/labmouse_controller.h"

namespace labmouse {

labmouse_briefing briefing_in_c(const ControllerBriefing& briefing);
labmouse_sense sense_in_c(const Sense& sense);

}  // namespace labmouse
