#include "labmouse/mouse/textbook_search.hpp"

#include <algorithm>
#include <cassert>

namespace labmouse {

SearchMethod search_method(std::string_view name) {
  assert(name == "breadth-first" || name == "a-star" || name == "dijkstra");
  return name == "a-star"     ? SearchMethod::a_star
         : name == "dijkstra" ? SearchMethod::dijkstra
                              : SearchMethod::breadth_first;
}

TextbookSearch::TextbookSearch(Size size, SearchMethod method, TieOrder order)
    : size_(size), method_(method), order_(order), nodes_(static_cast<std::size_t>(size.area())) {
  queue_.reserve(nodes_.size());
  way_.reserve(nodes_.size());
}

bool TextbookSearch::search(const WallSet& passages, Pose start, const CellSet& goals) {
  nodes_.assign(nodes_.size(), Node{});
  queue_.clear();
  way_.clear();
  expanded_ = found_ = 0;
  goal_ = start.cell;
  goal_found_ = goals.contains(start.cell);
  find(start.cell, {true, 0, start.heading}, 0);
  while (!queue_.empty() && !(goal_found_ && method_ == SearchMethod::a_star)) expand(take(), passages, goals);
  if (goal_found_) trace(start.cell);
  return goal_found_;
}

/// Takes the next cell from the queue.
Cell TextbookSearch::take() {
  std::pop_heap(queue_.begin(), queue_.end(), later);
  const Cell cell = queue_.back().cell;
  queue_.pop_back();
  ++expanded_;
  return cell;
}

/// Finds the neighbours of a cell that were not found before.
void TextbookSearch::expand(Cell cell, const WallSet& passages, const CellSet& goals) {
  const Node from = node(cell);
  for (const Heading direction : order_.from(from.heading)) {
    const Cell next = neighbour(cell, direction);
    if (!passages.contains(wall_at(cell, direction)) || node(next).found) continue;
    find(next, {true, from.cost + 1, direction}, expanded_ > 1 && direction != from.heading ? 1 : 0);
    if (goal_found_ || !goals.contains(next)) continue;
    goal_found_ = true;
    goal_ = next;
    if (method_ == SearchMethod::a_star) return;
  }
}

void TextbookSearch::find(Cell cell, const Node& as, int turns) {
  node(cell) = as;
  ++found_;
  Waiting waiting{0, found_, cell};
  if (method_ == SearchMethod::a_star) waiting.key = as.cost + turns;
  if (method_ == SearchMethod::dijkstra) waiting = {as.cost, size_.index(cell), cell};
  queue_.push_back(waiting);
  std::push_heap(queue_.begin(), queue_.end(), later);
}

/// Writes the way from the start to the goal.
void TextbookSearch::trace(Cell start) {
  for (Cell cell = goal_; cell != start; cell = neighbour(cell, opposite(way_.back())))
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
