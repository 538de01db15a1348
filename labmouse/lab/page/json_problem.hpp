// What is wrong with a text that is no JSON.
#pragma once

#include <string_view>

#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// The first mistake with its line and column.
Problem json_problem(std::string_view text);

}  // namespace labmouse
