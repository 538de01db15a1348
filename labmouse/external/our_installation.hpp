// Where labmouse itself lies, which holds the built-in mazes.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace labmouse {

/// Our programs, libraries and Python packages in these folders, in usual places for installations and in the folder of
/// a mouse; and the file that this code was loaded from. Sorted.
std::vector<std::string> our_installation(const std::set<std::string>& folders, const std::string& folder);

/// The paths that match a pattern with `*`.
std::vector<std::string> matches_of(const std::string& pattern);

}  // namespace labmouse
