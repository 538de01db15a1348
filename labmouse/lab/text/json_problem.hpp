// What is wrong with a text that is no JSON.
#pragma once

#include <string_view>

#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// The first mistake with its line and column, of a text for which read_json has nothing. Where lists stand in each
/// other too deeply there is no place.
Problem json_problem(std::string_view text);

}  // namespace labmouse
