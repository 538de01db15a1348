// Finds the installation of labmouse, which contains the built-in mazes.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace labmouse {

/// Programs, libraries and Python packages of labmouse in these folders, in usual installation places and in a mouse's
/// folder; and the file of this code. Sorted.
std::vector<std::string> our_installation(const std::set<std::string>& folders, const std::string& folder);

/// The file that this code was loaded from: a program or a library.
std::string file_of_this_code();

/// The paths that match a pattern with `*`.
std::vector<std::string> matches_of(const std::string& pattern);

}  // namespace labmouse
