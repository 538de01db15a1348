// Explains why a text is no valid JSON.
#pragma once

#include <string_view>

#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// The first error with its line and column, for a text that read_json() discards. Nesting that is too deep has no
/// position.
Problem json_problem(std::string_view text);

}  // namespace labmouse
