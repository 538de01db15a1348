// Depth-first search, also called recursive backtracking: walk at random into cells not yet visited; at a dead end go
// back to the last cell that has an unvisited neighbour. Long winding corridors, few and long dead ends.
//
// Source: depth-first search after Trémaux (Lucas, "Récréations mathématiques", 1882); as a maze maker see Buck,
// "Mazes for Programmers" (2015), chapter 5.
#include <optional>

#include "labmouse/maze/generators/loops.hpp"

namespace labmouse {
namespace {

// A random heading among those that lead to an unvisited cell.
std::optional<Heading> way_on(Size size, const CellSet& visited, Cell cell, Rng& rng) {
  std::vector<Heading> ways;
  for (const Heading heading : all_headings)
    if (const Cell next = neighbour(cell, heading); size.contains(next) && !visited.contains(next))
      ways.push_back(heading);
  if (ways.empty()) return std::nullopt;
  return draw(ways, rng);
}

Maze make_depth_first(const GeneratorOrder& order) {
  Rng rng(order.seed);
  MazeDraft draft(order.size, MazeDraft::Inside::closed);
  CellSet visited;
  visited.insert(draft.start());
  std::vector<Cell> trail = {draft.start()};
  while (!trail.empty()) {
    const Cell cell = trail.back();
    const auto way = way_on(order.size, visited, cell, rng);
    if (!way) {
      trail.pop_back();
      continue;
    }
    draft.open(cell, *way);
    trail.push_back(neighbour(cell, *way));
    visited.insert(trail.back());
  }
  open_loops(draft, order);
  return Maze(draft);
}

}  // namespace

constinit const Generator depth_first_generator = {
    .name = "depth-first",
    .summary = "long winding corridors",
    .refuses = refuses_out_of_range,
    .make = make_depth_first,
};

}  // namespace labmouse
