// Names of mice in tables.
#pragma once

#include <string>
#include <vector>

namespace labmouse {

/// Printable names of mice. Long commands are cut to their end, which contains the file name, if all names stay
/// different.
std::vector<std::string> mouse_names(const std::vector<std::string>& specs);

}  // namespace labmouse
