// Pilots in C that are linked in, by their table of functions.
#pragma once

#include <memory>

#include "labmouse/contest/pilot_code.hpp"
#include "labmouse/hardware/labmouse_pilot.h"

namespace labmouse {

/// Such a pilot for one contest. The table must outlive it; its functions may be called from several threads at once,
/// each for contests of its own.
std::unique_ptr<PilotCode> pilot_in_c(const struct labmouse_pilot& table, const PilotBriefing& briefing);

}  // namespace labmouse
