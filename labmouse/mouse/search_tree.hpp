// A breadth-first search as textbooks write it: one queue, and the four directions in a fixed order.
//
// DistanceField computes the same distances far faster, but does not rank equally short routes. Here the order in which
// cells are found decides, as in the programs of the capstone reports (docs/research/reports.md).
#pragma once

#include <span>
#include <vector>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/connected_cells.hpp"
#include "labmouse/mouse/route.hpp"
#include "labmouse/mouse/tie_order.hpp"

namespace labmouse {

/// Shortest routes, in moves of up to `longest` cells, from one pose to every cell. Takes all its memory when made.
class SearchTree {
 public:
  /// The order in which the cells along one direction are found.
  enum class Reach : std::uint8_t { nearest_first, farthest_first };

  SearchTree(Size size, int longest, TieOrder order, Reach reach = Reach::nearest_first);

  /// Searches anew over the given passages (all inside the size). Directions are tried in the order of a mouse that
  /// came along the tree, with the heading of its last move.
  void grow(const WallSet& passages, Pose root);
  /// The same for routes that only pass cells of `through`; the root may be passed, and any cell may be a route's end.
  void grow(const WallSet& passages, Pose root, const CellSet& through);
  /// The same over a map; the neighbours of each cell are found in the order of its set.
  void grow(const ConnectedCells& map, Pose root);

  /// Moves from the root, or unreachable.
  int distance(Cell cell) const;
  bool reaches(Cell cell) const { return distance(cell) < unreachable; }
  /// The reached cells in the order in which they were found, the root first.
  std::span<const Cell> found() const { return found_; }
  /// Where the move into a reached cell begins; the root's own is the root.
  Cell before(Cell cell) const;
  /// The end of the first move on the way to a reached cell other than the root.
  Cell first_towards(Cell cell) const;

 private:
  struct Node {
    int distance = unreachable;
    Cell before;
    Heading heading = Heading::north;
  };
  Node& node(Cell cell) { return nodes_[static_cast<std::size_t>(size_.index(cell))]; }
  const Node& node(Cell cell) const { return nodes_[static_cast<std::size_t>(size_.index(cell))]; }
  /// find_from(cell) finds what one move from a found cell leads to.
  template <class FindFrom>
  void grow_from(Pose root, FindFrom find_from);
  void find(Cell cell, Cell before, Heading heading);

  Size size_;
  int longest_;
  TieOrder order_;
  Reach reach_;
  std::vector<Node> nodes_;
  std::vector<Cell> found_;
};

/// The straight move from one cell to another in its row or column.
Move move_between(Cell from, Cell to);

}  // namespace labmouse
