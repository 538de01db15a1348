// Adapter for controllers written in C and linked into the program as a table of functions.
#pragma once

#include <memory>

#include "labmouse/contest/controller_code.hpp"
#include "labmouse/hardware/labmouse_controller.h"

namespace labmouse {

/// Makes such a controller for one contest. Duties beyond `LABMOUSE_FULL` are cut to it, and an unknown word counts as
/// a forfeit.
/// @param table the functions, none of them null. It must outlive the result. The functions must be thread-safe,
///   because several contests may run at once; they must not throw.
/// @param briefing copied; it need not outlive the result.
/// @return never null. Its destructor calls `end`.
/// @pre the robot of the briefing has hardware.
std::unique_ptr<ControllerCode> controller_in_c(const struct labmouse_controller& table,
                                                const ControllerBriefing& briefing);

}  // namespace labmouse
