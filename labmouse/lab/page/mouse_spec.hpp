// Mice that a page can race: the built-in ones and the oracle, without files.
#pragma once

#include <span>
#include <string>

#include "labmouse/lab/mice/specs.hpp"

namespace labmouse {

/// Reads SPECs as read_specs does. Refused are external mice, since a page starts no programs, and mice files and
/// priors of files, since it reads none.
SpecResult read_page_mice(std::span<const std::string> specs);

}  // namespace labmouse
