// Any bytes as a link to a maze, as they are and with the checksum that they would need: there is a maze or an error,
// and a maze has no other link.
#include <cstdlib>

#include "labmouse/lab/mazes/maze_link.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

namespace {

void check(std::string_view link) {
  const auto result = read_link(link);
  if (result.maze.has_value() != result.error.empty()) std::abort();
  if (result.maze && link_of(*result.maze) != link) std::abort();
}

/// The text with its checksum (FNV-1a) behind it.
std::string summed(std::string text) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
  std::uint32_t hash = 0x811C9DC5U;
  for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x01000193U;
  for (int i = 0; i < 6; ++i, hash >>= 6U) text += digits[hash & 63U];
  return text;
}

}  // namespace

LABMOUSE_FUZZER(link) {
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  check(text);
  check(summed(text));
  return 0;
}

}  // namespace labmouse::fuzz
