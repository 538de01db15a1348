// External mice in a SPEC: `capstone:FILE`, `program:COMMAND`, `controller:COMMAND`, `firmware:FILE`, `mms:COMMAND`,
// and built-in mice with external parts, `MOUSE:parts=COMMAND`. Everything after the first colon, or after `parts=`,
// including commas, belongs to the mouse.
#pragma once

#include <atomic>
#include <string>
#include <string_view>

#include "labmouse/external/limits.hpp"
#include "labmouse/lab/mice/contestant.hpp"
#include "labmouse/lab/text/parts_spec.hpp"

namespace labmouse {

/// Whether a SPEC starts a program: that of an external mouse, or of parts of a controller.
constexpr bool is_external_spec(std::string_view spec) {
  return spec.starts_with("capstone:") || spec.starts_with("program:") || spec.starts_with("controller:") ||
         spec.starts_with("mms:") || spec.starts_with("firmware:") || spec.starts_with("guest:") ||
         spec.starts_with("pilot:") || parts_place(spec) != std::string_view::npos;
}

/// Reads the SPEC of one external mouse into the result, as a contestant of its world; on failure sets its error. Of a
/// built-in mouse with external parts only these are read: the contestant has no kind.
void read_external_spec(std::string_view spec, const ExternalOptions& options, SpecResult& result);

}  // namespace labmouse
