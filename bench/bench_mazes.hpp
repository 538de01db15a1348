// The mazes of all benchmarks: those in the folder LABMOUSE_MAZES if it is set and has mazes of the size, such as real
// contest mazes; otherwise generated ones.
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
