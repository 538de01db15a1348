// Mice files in a SPEC: `mice-file:FILE` is all mice of a file, `mice-file:FILE:NAME` one of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/mice/contestant.hpp"

namespace labmouse {

/// Reads a built-in mouse, which may have external parts, with that value of a parameter if it is not null; returns the
/// error, or an empty text.
using ReadOwnMouse = std::string (*)(std::string_view spec, const ExternalOptions& options, const Setting* value,
                                     std::vector<Contestant>& mice);

/// Reads the SPEC of a mice file into the result; on failure sets its error and its problems. If `value` is not null,
/// the mice are variants with that value, as read_variants makes them.
void read_mice_file_spec(std::string_view spec, const ExternalOptions& options, const Setting* value,
                         ReadOwnMouse read_own, SpecResult& result);

}  // namespace labmouse
