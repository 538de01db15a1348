// Prim: grow the maze from the start; open a random wall between it and the rest, until no cell is left. Many short
// dead ends, and short routes outwards from the start.
//
// Source: Prim, "Shortest connection networks and some generalizations" (Bell System Technical Journal, 1957), with
// random choices in place of lengths.
#include "labmouse/maze/generators/loops.hpp"

namespace labmouse {
namespace {

// A step out of the grown part; the neighbour may have been added meanwhile.
struct Way {
  Cell from;
  Heading heading;
};

void add_ways(Size size, const CellSet& grown, Cell from, std::vector<Way>& ways) {
  for (const Heading heading : all_headings)
    if (const Cell to = neighbour(from, heading); size.contains(to) && !grown.contains(to))
      ways.push_back({from, heading});
}

Maze make_prim(const GeneratorOrder& order) {
  Rng rng(order.seed);
  MazeDraft draft(order.size, MazeDraft::Inside::closed);
  CellSet grown;
  grown.insert(draft.start());
  std::vector<Way> ways;
  add_ways(order.size, grown, draft.start(), ways);
  while (!ways.empty()) {
    const auto [from, heading] = draw(ways, rng);
    const Cell to = neighbour(from, heading);
    if (grown.contains(to)) continue;
    draft.open(from, heading);
    grown.insert(to);
    add_ways(order.size, grown, to, ways);
  }
  open_loops(draft, order);
  return Maze(draft);
}

}  // namespace

constinit const Generator prim_generator = {
    .name = "prim",
    .summary = "many short dead ends",
    .refuses = refuses_out_of_range,
    .make = make_prim,
};

}  // namespace labmouse
