#include "labmouse/mouse/textbook_search.hpp"

#include <algorithm>
#include <cassert>
#include <optional>

#include "labmouse/mouse/search_tree.hpp"

namespace labmouse {

SearchMethod search_method(std::string_view name) {
  assert(name == "breadth-first" || name == "a-star" || name == "dijkstra");
  return name == "a-star"     ? SearchMethod::a_star
         : name == "dijkstra" ? SearchMethod::dijkstra
                              : SearchMethod::breadth_first;
}

TextbookSearch::TextbookSearch(Size size, std::size_t most_edges, SearchMethod method)
    : size_(size), method_(method), nodes_(static_cast<std::size_t>(size.area())) {
  heap_.reserve(most_edges);
  way_.reserve(nodes_.size());
}

bool TextbookSearch::search(const WalkedPassages& passages, Cell start, const CellSet& goals) {
  nodes_.assign(nodes_.size(), Node{});
  heap_.clear();
  way_.clear();
  put_ = found_ = 0;
  std::optional<Cell> goal;
  if (goals.contains(start)) goal = start;
  reach(start, {true}, passages);
  // The report's A* takes the start for a new cell when an edge leads back to it. The report's 141 cells in maze 1 can
  // only be reproduced so.
  if (method_ == SearchMethod::a_star) node(start).reached = false;
  while (!heap_.empty() && !(goal && method_ == SearchMethod::a_star)) {
    const Edge edge = take();
    if (node(edge.to).reached) continue;
    ++found_;
    reach(edge.to, {true, node(edge.from).cells + 1, move_between(edge.from, edge.to).direction}, passages);
    if (!goal && goals.contains(edge.to)) goal = edge.to;
  }
  if (goal) trace(start, *goal);
  return goal.has_value();
}

/// Puts the edges out of a new cell into the queue.
void TextbookSearch::reach(Cell cell, Node as, const WalkedPassages& passages) {
  node(cell) = as;
  passages.from(cell, [&](Cell to) {
    if (node(to).reached) return;
    const bool turns = as.cells > 0 && move_between(cell, to).direction != as.heading;
    const int key = method_ == SearchMethod::breadth_first ? put_
                    : method_ == SearchMethod::a_star      ? as.cells + 1 + (turns ? 1 : 0)
                                                           : as.cells + 1;
    put({key, cell, to});
    ++put_;
  });
}

// Our own heap, because the order of equal keys matters here and differs between libraries.

void TextbookSearch::put(const Edge& edge) {
  std::size_t place = heap_.size();
  heap_.push_back(edge);
  while (place > 0 && edge.key < heap_[(place - 1) / 2].key) {
    heap_[place] = heap_[(place - 1) / 2];
    place = (place - 1) / 2;
  }
  heap_[place] = edge;
}

TextbookSearch::Edge TextbookSearch::take() {
  const Edge first = heap_.front(), last = heap_.back();
  heap_.pop_back();
  if (heap_.empty()) return first;
  std::size_t place = 0;
  for (std::size_t child = 1; child < heap_.size(); child = 2 * place + 1) {
    if (child + 1 < heap_.size() && heap_[child + 1].key < heap_[child].key) ++child;
    if (last.key <= heap_[child].key) break;
    heap_[place] = heap_[child];
    place = child;
  }
  heap_[place] = last;
  return first;
}

/// Writes the way from the start to the goal.
void TextbookSearch::trace(Cell start, Cell goal) {
  for (Cell cell = goal; cell != start; cell = neighbour(cell, opposite(way_.back())))
    way_.push_back(node(cell).heading);
  std::reverse(way_.begin(), way_.end());
}

void merge_strides(std::span<const Heading> way, int longest, std::vector<Move>& moves) {
  for (std::size_t first = 0, end; first < way.size(); first = end) {
    end = first;
    while (end < way.size() && way[end] == way[first]) ++end;
    int left = static_cast<int>(end - first);
    for (int cells = left % longest == 0 ? longest : left % longest; left > 0; left -= cells, cells = longest)
      moves.push_back({way[first], cells});
  }
}

}  // namespace labmouse
