// The map of the robots in the fifth capstone report: the passages that they walked through, in the order of walking.
#pragma once

#include <cstddef>
#include <vector>

#include "labmouse/grid/cell.hpp"

namespace labmouse {

/// A graph of cells with an edge for each passage that was walked, in both directions; a passage walked again is stored
/// again. Takes all its memory when made.
///
/// The report's program has a bug, which is kept: before it adds an edge out of the cell that it leaves, it looks for
/// one fixed cell instead of the cell that it enters. So walking out of that cell, or out of one with an edge to it,
/// adds no edge there; walking into it does. Some maps have no way to the goal for that reason alone.
class WalkedPassages {
 public:
  /// The fixed cell of that bug.
  static constexpr Cell slip{1, 0};

  /// `walks` is the number of steps that are certainly stored. After these, only steps through new passages are.
  WalkedPassages(Size size, int walks);

  /// Stores a step between neighbouring cells.
  void walk(Cell from, Cell to);

  /// Calls visit(cell) with the end of each edge out of a cell, in the order of walking.
  template <class Visit>
  void from(Cell cell, Visit visit) const {
    for (int edge = lists_[index(cell)].first; edge != none; edge = edges_[static_cast<std::size_t>(edge)].next)
      visit(edges_[static_cast<std::size_t>(edge)].to);
  }
  bool has(Cell from, Cell to) const;
  /// The number of edges.
  std::size_t edges() const { return edges_.size(); }
  /// The number of edges that it has room for.
  std::size_t most_edges() const { return edges_.capacity(); }
  Size size() const { return size_; }

 private:
  static constexpr int none = -1;
  struct Edge {
    Cell to;
    int next = none;  ///< next edge out of the same cell
  };
  struct List {
    int first = none, last = none;
  };

  std::size_t index(Cell cell) const { return static_cast<std::size_t>(size_.index(cell)); }
  void add(Cell from, Cell to);

  Size size_;
  std::size_t repeats_left_;
  std::vector<Edge> edges_;
  std::vector<List> lists_;
};

}  // namespace labmouse
