// Adapter for parts of the controller that are written in C and linked into the program as a table of functions.
#pragma once

#include <memory>

#include "labmouse/contest/controller_code.hpp"
#include "labmouse/controller/parts.hpp"
#include "labmouse/hardware/labmouse_controller.h"

namespace labmouse {

/// Makes such parts for one contest. Duties beyond `LABMOUSE_FULL` and evidence beyond 127 are cut to these.
/// @param table the functions; any may be null. Without `estimate`, `evidence` or `follow`, the built-in part is used.
///   It must outlive the result. The functions must be thread-safe, because several contests may run at once; they must
///   not throw.
/// @param briefing copied; it need not outlive the result.
/// @return never null. Its destructor calls `end`.
/// @pre the robot of the briefing has hardware.
std::unique_ptr<PartsOwner> parts_in_c(const struct labmouse_parts& table, const ControllerBriefing& briefing);

}  // namespace labmouse
