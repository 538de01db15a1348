#include "labmouse/maze/symmetry.hpp"

#include <algorithm>

namespace labmouse {
namespace {

/// -1, 0 or 1: whether a sorts before, equal to or after b, row by row.
int order_of(const CellSet& a, const CellSet& b) {
  const auto [in_a, in_b] = std::mismatch(a.rows(), a.rows() + max_side, b.rows());
  if (in_a == a.rows() + max_side) return 0;
  return *in_a < *in_b ? -1 : 1;
}

}  // namespace

WallSet transformed(const WallSet& walls, Size size, Symmetry symmetry) {
  WallSet moved;
  walls.for_each([&](Wall wall) {
    moved.insert(wall_at(transformed(wall.cell, size, symmetry), transformed(wall.side, symmetry)));
  });
  return moved;
}

Maze transformed(const Maze& maze, Symmetry symmetry) {
  const Size size = maze.size();
  MazeDraft draft(transformed(size, symmetry), MazeDraft::Inside::closed);
  transformed(maze.open_walls(), size, symmetry).for_each([&](Wall wall) { draft.open(wall.cell, wall.side); });
  draft.set_start(transformed(maze.start(), size, symmetry), transformed(maze.start_heading(), symmetry));
  maze.goals().for_each([&](Cell goal) { draft.add_goal(transformed(goal, size, symmetry)); });
  return Maze(draft);
}

bool operator<(const CanonicalWalls& a, const CanonicalWalls& b) {
  if (a.size.width != b.size.width) return a.size.width < b.size.width;
  if (a.size.height != b.size.height) return a.size.height < b.size.height;
  if (const int order = order_of(a.open.north(), b.open.north()); order != 0) return order < 0;
  return order_of(a.open.east(), b.open.east()) < 0;
}

CanonicalWalls canonical_walls(const Maze& maze) {
  CanonicalWalls least = {maze.size(), maze.open_walls()};
  for (const Symmetry symmetry : all_symmetries) {
    const CanonicalWalls other = {transformed(maze.size(), symmetry),
                                  transformed(maze.open_walls(), maze.size(), symmetry)};
    if (other < least) least = other;
  }
  return least;
}

}  // namespace labmouse
