// A whole maze in a text that can stand in a link: letters, digits, `-`, `_` and `.` only.
//
//   1.4x2.ABn.AA.4A.corridor.-hhrkD
//   | |   |   |  |  |        '- checksum of all before it
//   | |   |   |  |  '- name; other bytes than letters, digits and `-` as `_` and two hexadecimal digits
//   | |   |   |  '- inner walls, a bit each: north sides by cell, then east sides; 1 is closed
//   | |   |   '- goals, or `c` for the centre
//   | |   '- start cell and heading
//   | '- width and height
//   '- version
//
// A cell is two digits, x and y. Digits are those of base64 for links, six bits each: A to Z, a to z, 0 to 9, `-`, `_`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "labmouse/lab/mazes/maze_files.hpp"

namespace labmouse {

/// The longest name in a link, in bytes. Of a longer one its end stands there, which of a path is the file.
inline constexpr std::size_t longest_link_name = 200;

/// Size, walls, start, heading, goals and name, with a checksum. About 110 characters for 16×16. Each maze has one
/// link.
std::string link_of(const NamedMaze& maze);

/// A maze, or why the text is none (cut, mistyped, of a later version): exactly one of the two is there.
struct ReadLinkResult {
  std::optional<NamedMaze> maze;
  std::string error;
};

/// Reads what link_of wrote, and nothing else. Never throws, whatever the text; the name that it gives can be any
/// bytes.
ReadLinkResult read_link(std::string_view link);

}  // namespace labmouse
