// Descriptions of mice for `labmouse mice`: a list of all, or the details of one.
#pragma once

#include <string>

#include "labmouse/lab/system/named_text.hpp"

namespace labmouse {

/// Each mouse in a line, and below it each of its parameters with default, type and range.
std::string mouse_list();

/// One mouse: summary, method, source and parameters; or an error for an unknown name.
NamedText mouse_sheet(const std::string& name);

}  // namespace labmouse
