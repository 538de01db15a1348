// Guests in a SPEC: `capstone:FILE`, `guest:COMMAND`, `pilot:COMMAND`, `mms:COMMAND`. What follows the colon is theirs
// up to its end.
#pragma once

#include <atomic>
#include <string>
#include <string_view>

#include "labmouse/guests/limits.hpp"
#include "labmouse/lab/mice/contestant.hpp"

namespace labmouse {

/// Whether a SPEC is that of a guest.
constexpr bool is_guest_spec(std::string_view spec) {
  return spec.starts_with("capstone:") || spec.starts_with("guest:") || spec.starts_with("pilot:") ||
         spec.starts_with("mms:");
}

/// Reads the SPEC of one guest into the result, as a contestant of its world; on failure sets its error.
void read_guest_spec(std::string_view spec, const GuestOptions& options, SpecResult& result);

}  // namespace labmouse
