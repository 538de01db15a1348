// Appearance of the walls of a picture, and a loop over them.
#pragma once

#include "labmouse/lab/drawing/drawing.hpp"

namespace labmouse::drawing {

enum class WallLook { open, closed, unknown, guessed_open, guessed_closed };

/// How to draw a wall of the maze (or its border) in these layers. A wrong guess is shown even where the wall is
/// unknown.
inline WallLook look_of(const Maze& maze, const DrawingLayers& layers, Wall wall) {
  if (on_border(wall, maze.size())) return WallLook::closed;
  if (layers.wrong && layers.wrong->contains(wall)) return WallLook::guessed_open;
  if (layers.false_walls && layers.false_walls->contains(wall)) return WallLook::guessed_closed;
  if (layers.unknown && layers.unknown->contains(wall)) return WallLook::unknown;
  return maze.open_walls().contains(wall) ? WallLook::open : WallLook::closed;
}

/// Calls visit(Wall) once for each wall of a maze of that size, the border included, row by row.
template <class Visit>
void for_each_wall(Size size, Visit visit) {
  for (int y = -1; y < size.height; ++y) {
    for (int x = -1; x < size.width; ++x) {
      if (x >= 0) visit(Wall{{x, y}, Heading::north});
      if (y >= 0) visit(Wall{{x, y}, Heading::east});
    }
  }
}

}  // namespace labmouse::drawing
