// Mazes of all kinds for tests of strategies: every generator, odd sizes, starts and goals anywhere, areas that are cut
// off.
#pragma once

#include <string>

#include "labmouse/chance/rng.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/generators/generator.hpp"

namespace labmouse::test {

/// The walls of a maze to change them.
inline MazeDraft draft_of(const Maze& maze) {
  MazeDraft draft(maze.size(), MazeDraft::Inside::closed);
  maze.open_walls().for_each([&](Wall wall) { draft.open(wall.cell, wall.side); });
  draft.set_start(maze.start(), maze.start_heading());
  maze.goals().for_each([&](Cell cell) { draft.add_goal(cell); });
  return draft;
}

/// The maze with every tenth passage closed: often some cells cannot be reached.
inline Maze cut(const Maze& maze, Rng& rng) {
  MazeDraft draft = draft_of(maze);
  maze.open_walls().for_each([&](Wall wall) {
    if (rng.chance(1, 10)) draft.close(wall.cell, wall.side);
  });
  return Maze(draft);
}

/// The maze with start and heading anywhere, and one to four goals anywhere.
inline Maze marked_anywhere(const Maze& maze, Rng& rng) {
  const auto any_cell = [&] { return maze.size().cell_at(rng.below(maze.size().area())); };
  CellSet goals;
  for (int count = 1 + rng.below(4); count > 0; --count) goals.insert(any_cell());
  const Cell start = any_cell();
  return maze.with_start(start, all_headings[static_cast<std::size_t>(rng.below(4))]).with_goals(goals);
}

/// A random maze with sides up to `side`, half of them marked anywhere and a few of them cut; kinds that take no such
/// size become 16×16.
inline Maze any_maze(Rng& rng, int side) {
  const auto generators = all_generators();
  const Generator& generator = *generators[static_cast<std::size_t>(rng.below(static_cast<int>(generators.size())))];
  const int width = 1 + rng.below(side), height = 1 + rng.below(side);
  GeneratorOrder order{{width, height}, rng.bits(), rng.chance(1, 2) ? 0 : rng.below(400)};
  if (!generator.refuses(order).empty()) order.size = {16, 16};
  Maze maze = generator.make(order);
  if (rng.chance(1, 2)) maze = marked_anywhere(maze, rng);
  return rng.chance(1, 8) ? cut(maze, rng) : maze;
}

/// The maze as a person sees it, for messages; headings other than north get lost.
inline std::string drawing_of(const Maze& maze) {
  const WriteResult written = drawing_format.write(maze.with_start(maze.start(), Heading::north));
  return '\n' + written.content.value_or("(" + written.reason + ")\n");
}

}  // namespace labmouse::test
