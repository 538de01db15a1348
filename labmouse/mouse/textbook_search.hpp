// The route search of the program in the fifth capstone report (docs/research/reports.md): breadth-first, A* or
// Dijkstra.
//
// All three keep a queue of edges and take one after the other from it; an edge that leads to a new cell puts the edges
// out of that cell into the queue. They differ in which edge is next, and in where they stop:
//
//     breadth-first   the one put in first                                                        when none is left
//     A*              the one with the fewest cells from the start, a turn at its beginning       in a goal
//                     counting as one more
//     Dijkstra        the one with the fewest cells from the start                                when none is left
//
// Equal edges come in the order of a binary heap. The cost of a turn is not passed on to the next cells, so A* prefers
// straight ways only among nearly equal ones, and may miss a shortest way by a cell. This is the report's A*: its
// heuristic is the turn, without an estimated distance. The report's Dijkstra was never written; this one is ours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "labmouse/grid/cell_set.hpp"
#include "labmouse/mouse/route.hpp"
#include "labmouse/mouse/walked_passages.hpp"

namespace labmouse {

enum class SearchMethod : std::uint8_t { breadth_first, a_star, dijkstra };

/// `breadth-first`, `a-star` or `dijkstra`; must be one of them.
SearchMethod search_method(std::string_view name);

/// A search that counts what it does. Takes all its memory when made.
class TextbookSearch {
 public:
  /// `most_edges` is the largest number of edges of a map.
  TextbookSearch(Size size, std::size_t most_edges, SearchMethod method);

  /// Searches anew; whether there is a way.
  bool search(const WalkedPassages& passages, Cell start, const CellSet& goals);

  /// The way to the goal that was reached first, direction by direction; empty where there is none or the start is a
  /// goal.
  std::span<const Heading> way() const { return way_; }
  /// Number of cells that an edge from the queue reached first: the goal counts, the start only in A*.
  int found() const { return found_; }

 private:
  struct Node {
    bool reached = false;
    int cells = 0;  ///< from the start
    Heading heading = Heading::north;
  };
  struct Edge {
    int key = 0;
    Cell from;
    Cell to;
  };

  Node& node(Cell cell) { return nodes_[static_cast<std::size_t>(size_.index(cell))]; }
  void reach(Cell cell, Node as, const WalkedPassages& passages);
  void put(const Edge& edge);
  Edge take();
  void trace(Cell start, Cell goal);

  Size size_;
  SearchMethod method_;
  std::vector<Node> nodes_;
  std::vector<Edge> heap_;
  std::vector<Heading> way_;
  int put_ = 0;
  int found_ = 0;
};

/// Merges a way into moves of up to `longest` cells; in each straight run the shortest move comes first. The moves are
/// appended.
void merge_strides(std::span<const Heading> way, int longest, std::vector<Move>& moves);

}  // namespace labmouse
