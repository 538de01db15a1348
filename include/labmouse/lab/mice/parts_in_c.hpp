// Adapter for parts of the controller that are written in C and linked into the program as a table of functions.
#pragma once

#include <memory>

#include "labmouse/contest/controller_code.hpp"
#include "labmouse/controller/parts.hpp"
#include "labmouse/hardware/labmouse_controller.h"

namespace labmouse {

/// Such parts for one contest. The table must outlive the result. Its functions must be thread-safe: several contests
/// may run at once.
std::unique_ptr<PartsOwner> parts_in_c(const struct labmouse_parts& table, const ControllerBriefing& briefing);

}  // namespace labmouse
