// Controllers in C that are linked in, by their table of functions.
#pragma once

#include <memory>

#include "labmouse/contest/controller_code.hpp"
#include "labmouse/hardware/labmouse_controller.h"

namespace labmouse {

/// Such a controller for one contest. The table must outlive it; its functions may be called from several threads at
/// once, each for contests of its own.
std::unique_ptr<ControllerCode> controller_in_c(const struct labmouse_controller& table,
                                                const ControllerBriefing& briefing);

}  // namespace labmouse
