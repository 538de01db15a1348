// Wilson: from a cell outside of the maze walk at random until the maze is met, erasing the loops of the walk; the walk
// becomes part of the maze. Every perfect maze of that size is equally likely.
//
// Limits: the walks take about as long as a random walk needs to find the first cell: milliseconds at 64×64.
// Source: Wilson, "Generating random spanning trees more quickly than the cover time" (STOC, 1996).
#include "labmouse/maze/generators/loops.hpp"

namespace labmouse {
namespace {

// The heading in which the walk last left each cell. Overwriting it when the walk returns erases the loop.
class Walk {
 public:
  explicit Walk(Size size) : size_(size), left_by_(static_cast<std::size_t>(size.area()), Heading::north) {}

  /// Walks at random from the cell until it meets the maze.
  void wander(Cell cell, const CellSet& in_maze, Rng& rng) {
    while (!in_maze.contains(cell)) {
      const auto heading = static_cast<Heading>(rng.below(4));
      if (!size_.contains(neighbour(cell, heading))) continue;
      left_by_[static_cast<std::size_t>(size_.index(cell))] = heading;
      cell = neighbour(cell, heading);
    }
  }

  Heading left_by(Cell cell) const { return left_by_[static_cast<std::size_t>(size_.index(cell))]; }

 private:
  Size size_;
  std::vector<Heading> left_by_;
};

Maze make_wilson(const GeneratorOrder& order) {
  Rng rng(order.seed);
  MazeDraft draft(order.size, MazeDraft::Inside::closed);
  CellSet in_maze;
  in_maze.insert(order.size.cell_at(rng.below(order.size.area())));
  Walk walk(order.size);
  CellSet::all(order.size).for_each([&](Cell cell) {
    walk.wander(cell, in_maze, rng);
    while (!in_maze.contains(cell)) {
      in_maze.insert(cell);
      const Heading heading = walk.left_by(cell);
      draft.open(cell, heading);
      cell = neighbour(cell, heading);
    }
  });
  open_loops(draft, order);
  return Maze(draft);
}

}  // namespace

constinit const Generator wilson_generator = {
    .name = "wilson",
    .summary = "every perfect maze is equally likely",
    .refuses = refuses_out_of_range,
    .make = make_wilson,
};

}  // namespace labmouse
