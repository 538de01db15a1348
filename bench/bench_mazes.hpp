// The mazes that are measured on: those of LABMOUSE_MAZES where it is set, so that figures on real contest mazes can be
// made again by whoever has them, and generated ones otherwise.
#pragma once

#include <cstdlib>
#include <vector>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/maze/generators/generator.hpp"

namespace labmouse {

inline std::vector<Maze> bench_mazes(int side) {
  std::vector<Maze> mazes;
  if (const char* folder = std::getenv("LABMOUSE_MAZES"))
    for (const NamedMaze& maze : load_mazes(std::vector<std::string>{folder}).mazes)
      if (maze.maze.size() == Size{side, side}) mazes.push_back(maze.maze);
  if (!mazes.empty()) return mazes;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    const GeneratorOrder order{{side, side}, seed, 60};
    const Generator& generator = contest_generator.refuses(order).empty() ? contest_generator : depth_first_generator;
    mazes.push_back(generator.make(order));
  }
  return mazes;
}

}  // namespace labmouse
