// A drive of the physical world as the log that its mouse would have written, and what a ruler would have said.
#pragma once

#include <span>
#include <string>

#include "labmouse/body/field.hpp"
#include "labmouse/contest/known_drive.hpp"

namespace labmouse {

/// CSV with a line for each tick, described in docs/how-to/robot-from-a-log.md: raw integers as the hardware gives them
/// and the duties that the program then set; behind those what no mouse knows: the way that it went, how far from it
/// the walls are that its sensors see, and where it is. A wall's field is empty where the mouse does not point along or
/// across it to a degree, or a sensor sees more than it alone.
std::string log_text(std::span<const LoggedTick> ticks, const Field& field, const Hardware& hardware);

}  // namespace labmouse
