// Generated mazes that nobody can foresee without a secret seed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// A shorter seed could be found by trying all texts until its hash fits.
inline constexpr std::size_t shortest_secret = 16;

/// The seed in the text of a file: its first line that is neither empty nor a comment (`#`), without blanks around it.
std::string secret_in(std::string_view text);

/// A number that the seed and a purpose determine. Numbers of other purposes say nothing of it, because it is a part of
/// a cryptographic hash.
std::uint64_t number_from(const std::string& secret, std::string_view purpose);

/// Mazes of one kind and size.
struct SecretMazes {
  int count = 0;
  std::string kind = "contest";  ///< the name of a generator
  int side = 16;                 ///< width and height in cells
};
inline constexpr int most_secret_mazes = 1000;

/// Why there are no such mazes; empty where there are.
std::string refuse(const SecretMazes& mazes);

/// The maze that the seed and a purpose determine. refuse() must accept the mazes.
Maze secret_maze(const SecretMazes& mazes, const std::string& secret, std::string_view purpose);

}  // namespace labmouse
