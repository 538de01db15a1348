#include "labmouse/contest/dead_ends.hpp"

#include "labmouse/maze/inspect.hpp"
#include "labmouse/maze/routes.hpp"

namespace labmouse {
namespace {

/// Enters the cells of a move. Returns false behind the first goal.
bool enter_cells(const SearchMove& move, const Maze& maze, DeadEndCount& count, CellSet& unseen) {
  for (int i = 1; i <= move.action.movement; ++i) {
    const Cell cell = neighbour(move.from.cell, move.to.heading, i);
    ++count.steps;
    if (unseen.contains(cell)) {
      unseen.erase(cell);
      ++count.seen;
    }
    if (maze.is_goal(cell)) return false;
  }
  return true;
}

}  // namespace

CellSet dead_ends_in(const Maze& maze) {
  CellSet cells;
  reachable_cells(maze).for_each([&](Cell cell) {
    if (count_open_sides(maze, cell) == 1 && cell != maze.start() && !maze.is_goal(cell)) cells.insert(cell);
  });
  return cells;
}

std::optional<DeadEndCount> dead_ends_of(const DriveRun& run, const Maze& maze) {
  if (run.kind != DriveRun::Kind::search || !run.gate_in) return std::nullopt;
  CellSet unseen = dead_ends_in(maze);
  DeadEndCount count;
  count.all = unseen.count();
  count.fewest_steps = shortest_in_cells(maze).value_or(0);
  for (const SearchMove& move : run.moves)
    if (!enter_cells(move, maze, count, unseen)) break;
  return count;
}

}  // namespace labmouse
