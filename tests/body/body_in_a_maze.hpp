// A body that keeps the maze and the hardware it refers to.
#pragma once

#include "labmouse/body/body.hpp"

namespace labmouse::test {

struct MazeAndHardware {
  Maze maze;
  Hardware hardware;
};

/// A Body with its own copies of maze and hardware.
struct BodyInAMaze : MazeAndHardware, Body {
  BodyInAMaze(const Maze& where, double side, const Hardware& built, const ErrorScale& scale = {},
              std::uint64_t seed = 1)
      : MazeAndHardware{where, built}, Body(maze, side, hardware, scale, seed) {}
};

}  // namespace labmouse::test
