// What is wrong with a text that is no JSON.
#pragma once

#include <string_view>

#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// The first mistake with its line and column.
Problem json_problem(std::string_view text);

/// Whether lists and objects stand in each other deeper than anything that labmouse writes: such a text is not worth
/// the memory that reading it takes.
bool is_too_deep(std::string_view text);

}  // namespace labmouse
