#include "labmouse/maze/inspect.hpp"

#include "labmouse/maze/wall_follower.hpp"

namespace labmouse {
namespace {

// Dead ends, junctions and loops, counted from the open sides of each reachable cell.
void count_shapes(const Maze& maze, Inspection& found) {
  int sides = 0;
  found.reachable.for_each([&](Cell cell) {
    const int open = count_open_sides(maze, cell);
    found.dead_ends += open == 1 ? 1 : 0;
    found.junctions += open >= 3 ? 1 : 0;
    sides += open;
  });
  // A passage out of a reachable cell leads to another one, so each was counted from both of its sides.
  found.loops = sides / 2 - found.reachable.count() + 1;
}

}  // namespace

int count_open_sides(const Maze& maze, Cell cell) {
  int open = 0;
  for (const Heading side : all_headings) open += maze.is_open(cell, side) ? 1 : 0;
  return open;
}

Inspection inspect(const Maze& maze, int longest_stride) {
  Inspection found;
  found.reachable = reachable_cells(maze);
  count_shapes(maze, found);
  found.shortest_cells = shortest_in_cells(maze);
  found.shortest_strides = shortest_in_strides(maze, longest_stride);
  found.left_follower_arrives = wall_follower_arrives(maze, Hand::left);
  found.right_follower_arrives = wall_follower_arrives(maze, Hand::right);
  found.contest_rules = check_contest_rules(maze);
  return found;
}

}  // namespace labmouse
