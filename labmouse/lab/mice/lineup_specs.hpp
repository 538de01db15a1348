// Lineups in a SPEC: `lineup:FILE` is all mice of a file, `lineup:FILE:NAME` one of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/mice/contestant.hpp"

namespace labmouse {

/// Reads a mouse of ours, with that value of a parameter where it is not null; returns what is wrong, or nothing.
using ReadOwnMouse = std::string (*)(std::string_view spec, const Setting* value, std::vector<Contestant>& mice);

/// Reads the SPEC of a lineup into the result; on failure sets its error and its problems. Where `value` is not null,
/// the mice are variants with that value, as read_variants makes them.
void read_lineup_spec(std::string_view spec, const GuestOptions& options, const Setting* value, ReadOwnMouse read_own,
                      SpecResult& result);

}  // namespace labmouse
