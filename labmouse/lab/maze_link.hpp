// A whole maze in a text that can stand in a link: letters, digits, `-`, `_` and `.` only.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "labmouse/lab/maze_files.hpp"

namespace labmouse {

/// Size, walls, start, heading, goals and name, with a checksum. About 100 characters for 16×16.
std::string link_of(const NamedMaze& maze);

/// A maze, or why the text is none (cut, mistyped, of a later version): exactly one of the two is there.
struct ReadLinkResult {
  std::optional<NamedMaze> maze;
  std::string error;
};

/// Reads what link_of wrote. Never throws, whatever the text.
ReadLinkResult read_link(std::string_view link);

}  // namespace labmouse
