#include "labmouse/lab/learn/maze_family.hpp"

#include <optional>

#include "labmouse/chance/rng.hpp"

namespace labmouse {
namespace {

// Number of mazes to generate before a family is refused because none of them is in the split.
constexpr int attempts_before_refusal = 4096;

std::uint64_t content_of(const Maze& maze) {
  const Size size = maze.size();
  std::uint64_t hash = Rng(static_cast<std::uint64_t>(size.width * (max_side + 1) + size.height)).bits();
  const auto mix = [&](std::uint64_t bits) { hash = Rng(hash ^ bits).bits(); };
  for (int y = 0; y < size.height; ++y) {
    mix(maze.open_walls().north().row(y));
    mix(maze.open_walls().east().row(y));
    mix(maze.goals().row(y));
  }
  mix(static_cast<std::uint64_t>(size.index(maze.start()) * 4) + static_cast<std::uint64_t>(maze.start_heading()));
  return hash;
}

Rng rng_of(std::uint64_t number) { return Rng(seed_for(0, "learn", number)); }

Maze next_maze(const MazeFamily& family, Rng& rng) {
  return family.generator->make({family.size, rng.bits(), family.loops});
}

}  // namespace

Split split_of(const Maze& maze) {
  switch (content_of(maze) >> 61U) {
    case 0:
      return Split::test;
    case 1:
      return Split::validation;
    default:
      return Split::train;
  }
}

std::string_view refuses(const MazeFamily& family) {
  const GeneratorOrder order{family.size, 1, family.loops};
  if (const auto reason = refuses_out_of_range(order); !reason.empty()) return reason;
  if (const auto reason = family.generator->refuses(order); !reason.empty()) return reason;
  Rng rng = rng_of(0);
  for (int attempt = 0; attempt < attempts_before_refusal; ++attempt)
    if (split_of(next_maze(family, rng)) == family.split) return {};
  return "so few mazes of this kind and size exist that none is in this split; choose a larger size";
}

Maze maze_of(const MazeFamily& family, std::uint64_t number) {
  // This ends with probability 1: refuses() has found such a maze, so each attempt has a positive chance.
  for (Rng rng = rng_of(number);;)
    if (const Maze maze = next_maze(family, rng); split_of(maze) == family.split) return maze;
}

}  // namespace labmouse
