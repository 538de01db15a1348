// The secret seed of a season, and what is drawn from it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/league/season.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"

namespace labmouse {

/// A shorter seed could be found by trying all texts until the hash fits.
inline constexpr std::size_t shortest_secret = 16;

/// SHA-256 of a text, as 64 hexadecimal digits.
std::string sha256_text(std::string_view text);

/// The seed in the text of a file: its first line that is neither empty nor a comment (`#`), without blanks around it.
std::string secret_in(std::string_view text);

/// The text of a file with that seed.
std::string secret_text(const std::string& secret);

/// A number that the seed and a purpose determine. Numbers of other purposes say nothing of it, because it is a part of
/// a cryptographic hash.
std::uint64_t number_from(const std::string& secret, std::string_view purpose);

/// The mazes of the examination: "examination 001", "examination 002" and so on.
std::vector<NamedMaze> examination_mazes(const ExaminationMazes& mazes, const std::string& secret);

}  // namespace labmouse
