// Makes file names from the names of mice and mazes.
#pragma once

#include <string>
#include <vector>

namespace labmouse {

/// The names as parts of paths, all different. Characters with a meaning in paths or shells become `_`; of equal
/// results the later ones get a number.
std::vector<std::string> file_names(const std::vector<std::string>& names);

/// The last part of a path, without its ending.
std::string stem_of(const std::string& path);

}  // namespace labmouse
