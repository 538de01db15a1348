// Names of mice and mazes as names of files.
#pragma once

#include <string>
#include <vector>

namespace labmouse {

/// The names as parts of paths, each different from the others: what could lead elsewhere or trouble a shell becomes
/// `_`, and where two names become one, the later ones get a number.
std::vector<std::string> file_names(const std::vector<std::string>& names);

/// The last part of a path, without its ending.
std::string stem_of(const std::string& path);

}  // namespace labmouse
