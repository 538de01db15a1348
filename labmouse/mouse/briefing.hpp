// What a mouse is told before it is put into the maze.
#pragma once

#include <cstdint>

#include "labmouse/grid/cell_set.hpp"
#include "labmouse/mouse/motion.hpp"
#include "labmouse/mouse/pose.hpp"

namespace labmouse {

struct Briefing {
  Size size;
  Pose start;
  CellSet goals;
  Motion motion = strides();
  /// Steps over both runs, the reset's among them.
  int budget = 1000;
  /// For mice that throw dice: all their chance comes from here.
  std::uint64_t seed = 0;
  /// Cells that a reading reaches at most, 1 or more: a reading of so many shows no wall at its end.
  int sight = max_side;
};

}  // namespace labmouse
