// What programs in C are told, in the structures of their header.
#pragma once

#include "labmouse/contest/pilot_code.hpp"
#include "labmouse/hardware/labmouse_pilot.h"

namespace labmouse {

labmouse_briefing briefing_in_c(const PilotBriefing& briefing);
labmouse_sense sense_in_c(const Sense& sense);

}  // namespace labmouse
