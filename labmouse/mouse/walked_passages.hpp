// The map of the fifth report's robots: the passages that they walked through, in the order of walking.
#pragma once

#include <cstddef>
#include <vector>

#include "labmouse/grid/cell.hpp"

namespace labmouse {

/// A graph of cells with an edge for each passage that was walked, in both directions; a passage walked again is stored
/// again. Takes all its memory when made.
///
/// The report's program has a slip, which is kept: before it adds an edge out of the cell that it leaves, it looks for
/// one fixed cell where it means the cell that it enters. So walking out of that cell, or out of one that has an edge
/// to it, adds no edge there; walking into it does. Some maps have no way to the goal for that reason alone.
class WalkedPassages {
 public:
  /// Where the slip is, in the report's program.
  static constexpr Cell slip{1, 0};

  /// `walks` is how many steps are stored for certain. Of more, those through a passage that is in the map are not.
  WalkedPassages(Size size, int walks);

  /// A step between neighbouring cells.
  void walk(Cell from, Cell to);

  /// Hands the end of each edge out of a cell to visit(cell), in the order of walking.
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
    int next = none;  ///< edge out of the same cell
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
