// Kruskal: take all walls in random order, and open each that still separates two parts. An even texture of short dead
// ends.
//
// Source: Kruskal, "On the shortest spanning subtree of a graph and the traveling salesman problem" (Proceedings of the
// American Mathematical Society, 1956), with a random order in place of lengths; union-find after Galler and Fischer
// (1964).
#include "labmouse/maze/generators/loops.hpp"

namespace labmouse {
namespace {

// Union-find over cells: each part is a tree that is named by its root.
class Parts {
 public:
  explicit Parts(Size size) : size_(size) {
    for (int index = 0; index < size.area(); ++index) parent_.push_back(index);
  }

  /// Joins the parts of the two cells; false if they were in the same part already.
  bool join(Cell a, Cell b) {
    const int root_a = root(size_.index(a));
    const int root_b = root(size_.index(b));
    parent(root_a) = root_b;
    return root_a != root_b;
  }

 private:
  int& parent(int index) { return parent_[static_cast<std::size_t>(index)]; }

  // Path halving keeps the trees flat.
  int root(int index) {
    while (parent(index) != index) {
      parent(index) = parent(parent(index));
      index = parent(index);
    }
    return index;
  }

  Size size_;
  std::vector<int> parent_;
};

Maze make_kruskal(const GeneratorOrder& order) {
  Rng rng(order.seed);
  MazeDraft draft(order.size, MazeDraft::Inside::closed);
  Parts parts(order.size);
  std::vector<Wall> lots = lots_of(WallSet::all(order.size));
  while (!lots.empty()) {
    const Wall wall = draw(lots, rng);
    if (parts.join(wall.cell, neighbour(wall.cell, wall.side))) draft.open(wall.cell, wall.side);
  }
  open_loops(draft, order);
  return Maze(draft);
}

}  // namespace

constinit const Generator kruskal_generator = {
    .name = "kruskal",
    .summary = "an even texture of dead ends",
    .refuses = refuses_out_of_range,
    .make = make_kruskal,
};

}  // namespace labmouse
