// What a season freezes: the files that decide its ranking besides the entries, and one hash of all of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/league/season.hpp"

namespace labmouse {

/// The list of the frozen files, or the error as a line for the user.
struct FrozenFiles {
  /// A line for each file, as `sha256sum` prints it: SHA-256, two spaces, path in the folder. Sorted by path. Its own
  /// SHA-256 is the hash of the season.
  std::string list;
  std::string error;
};

/// Lists the season file, which says the limits and the number and kind of mazes, the robot and other files that its
/// settings name, the practice mazes, and the results of the seasons before.
/// @param season_file the text of the season file.
FrozenFiles frozen_files(const std::string& folder, const Season& season, std::string_view season_file);

/// How the files differ from the list that `init` wrote: an error for each, as a line for the user.
/// @param written the content of that list.
/// @param now as of frozen_files().
std::vector<std::string> frozen_changes(const std::string& folder, std::string_view written, std::string_view now);

}  // namespace labmouse
