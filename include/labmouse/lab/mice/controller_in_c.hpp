// Adapter for controllers written in C and linked into the program as a table of functions.
#pragma once

#include <memory>

#include "labmouse/contest/controller_code.hpp"
#include "labmouse/hardware/labmouse_controller.h"

namespace labmouse {

/// Makes such a controller for one contest. The table must outlive it. Its functions must be thread-safe: several
/// contests may run at once.
std::unique_ptr<ControllerCode> controller_in_c(const struct labmouse_controller& table,
                                                const ControllerBriefing& briefing);

}  // namespace labmouse
