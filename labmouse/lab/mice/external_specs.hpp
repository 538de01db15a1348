// External mice in a SPEC: `capstone:FILE`, `program:COMMAND`, `controller:COMMAND`, `mms:COMMAND`. Everything after
// the colon, including commas, belongs to the mouse.
#pragma once

#include <atomic>
#include <string>
#include <string_view>

#include "labmouse/external/limits.hpp"
#include "labmouse/lab/mice/contestant.hpp"

namespace labmouse {

/// Whether a SPEC is that of an external mouse.
constexpr bool is_external_spec(std::string_view spec) {
  return spec.starts_with("capstone:") || spec.starts_with("program:") || spec.starts_with("controller:") ||
         spec.starts_with("mms:") || spec.starts_with("guest:") || spec.starts_with("pilot:");
}

/// Reads the SPEC of one external mouse into the result, as a contestant of its world; on failure sets its error.
void read_external_spec(std::string_view spec, const ExternalOptions& options, SpecResult& result);

}  // namespace labmouse
