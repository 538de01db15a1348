// Reads SPECs for the page, which has no files and no programs: built-in mice and the oracle.
#pragma once

#include <span>
#include <string>

#include "labmouse/lab/mice/specs.hpp"

namespace labmouse {

/// Reads SPECs as read_specs does. Refuses external mice, mice files and prior files.
SpecResult read_page_mice(std::span<const std::string> specs);

}  // namespace labmouse
