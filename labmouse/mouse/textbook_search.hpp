// One way from here to a goal, searched as textbooks write it: breadth-first, A* or Dijkstra, over cells.
//
// All three keep a queue of found cells and take one after the other from it; they differ in which is next, and in
// where they stop:
//
//     breadth-first   the one found first                                          when every cell was taken
//     A*              the cheapest, a turn just before it costing one more; then   with the first goal found
//                     the one found first
//     Dijkstra        the cheapest; then the first in the total order of cells     when every cell was taken
//
// A cell belongs to whoever finds it first. What a turn costs is not handed on to the cells behind it, so A* prefers
// straight ways only among nearly equal ones, and may miss a shortest way by a cell where a longer one turns less. That
// is the A* of the report that the visit counter comes from; its heuristic is this turn, and no distance is estimated.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/route.hpp"
#include "labmouse/mouse/tie_order.hpp"

namespace labmouse {

enum class SearchMethod : std::uint8_t { breadth_first, a_star, dijkstra };

/// `breadth-first`, `a-star` or `dijkstra`; must be one of them.
SearchMethod search_method(std::string_view name);

/// A search that counts what it does. Takes all its memory when made.
class TextbookSearch {
 public:
  TextbookSearch(Size size, SearchMethod method, TieOrder order);

  /// Searches anew over the given passages (all inside the size); whether there is a way.
  bool search(const WallSet& passages, Pose start, const CellSet& goals);

  /// The way to the goal found first, direction by direction; empty where there is none or the start is a goal.
  std::span<const Heading> way() const { return way_; }
  /// Cells taken from the queue, to find their neighbours.
  int expanded() const { return expanded_; }
  /// Cells found, the start among them.
  int found() const { return found_; }

 private:
  struct Node {
    bool found = false;
    int cost = 0;  ///< cells from the start
    Heading heading = Heading::north;
  };
  /// A found cell waits: the smallest key is next, among equal ones the smallest number.
  struct Waiting {
    int key = 0;
    int number = 0;
    Cell cell;
  };

  static bool later(const Waiting& a, const Waiting& b) { return a.key != b.key ? a.key > b.key : a.number > b.number; }
  Node& node(Cell cell) { return nodes_[static_cast<std::size_t>(size_.index(cell))]; }
  void find(Cell cell, const Node& as, int turns);
  Cell take();
  void expand(Cell cell, const WallSet& passages, const CellSet& goals);
  void trace(Cell start);

  Size size_;
  SearchMethod method_;
  TieOrder order_;
  std::vector<Node> nodes_;
  std::vector<Waiting> queue_;
  std::vector<Heading> way_;
  Cell goal_;
  int expanded_ = 0;
  int found_ = 0;
  bool goal_found_ = false;
};

/// Merges a way into moves of up to `longest` cells: each straight run from its end, so that what is left over comes
/// first. The moves are appended.
void merge_strides(std::span<const Heading> way, int longest, std::vector<Move>& moves);

}  // namespace labmouse
