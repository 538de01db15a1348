// Encodes a whole maze as a text for URLs: letters, digits, `-`, `_` and `.` only.
//
//   1.4x2.ABn.AA.4A.corridor.-hhrkD
//   | |   |   |  |  |        '- checksum of all before it
//   | |   |   |  |  '- name; bytes other than letters, digits and `-` are `_` and two hexadecimal digits
//   | |   |   |  '- inner walls, a bit each: north sides by cell, then east sides; 1 is closed
//   | |   |   '- goals, or `c` for the centre
//   | |   '- start cell and heading
//   | '- width and height
//   '- version
//
// A cell is two digits, x and y. Digits are those of base64url, six bits each: A to Z, a to z, 0 to 9, `-`, `_`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "labmouse/lab/mazes/maze_files.hpp"

namespace labmouse {

/// The longest name in a link, in bytes. Of a longer name only the end is kept, which contains the file name.
inline constexpr std::size_t longest_link_name = 200;

/// The link of a maze: size, walls, start, heading, goals and name, with a checksum. About 110 characters for 16×16.
/// Each maze has exactly one link.
std::string link_of(const NamedMaze& maze);

/// Either a maze, or the error (link cut, mistyped, or of a later version).
struct ReadLinkResult {
  std::optional<NamedMaze> maze;
  std::string error;
};

/// Reads a link that link_of wrote. Never throws. The name may contain any bytes.
ReadLinkResult read_link(std::string_view link);

}  // namespace labmouse
