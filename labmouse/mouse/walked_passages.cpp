#include "labmouse/mouse/walked_passages.hpp"

#include <algorithm>

namespace labmouse {

WalkedPassages::WalkedPassages(Size size, int walks)
    : size_(size), repeats_left_(2 * static_cast<std::size_t>(walks)), lists_(static_cast<std::size_t>(size.area())) {
  constexpr std::size_t neighbours = 4;
  edges_.reserve(repeats_left_ + neighbours * lists_.size());
}

void WalkedPassages::walk(Cell from, Cell to) {
  if (from != slip && !has(from, slip)) add(from, to);
  add(to, from);
}

bool WalkedPassages::has(Cell from, Cell to) const {
  bool found = false;
  this->from(from, [&](Cell end) { found |= end == to; });
  return found;
}

void WalkedPassages::add(Cell from, Cell to) {
  if (has(from, to)) {
    if (repeats_left_ == 0) return;
    --repeats_left_;
  }
  const int edge = static_cast<int>(edges_.size());
  edges_.push_back({to});
  List& list = lists_[index(from)];
  (list.first == none ? list.first : edges_[static_cast<std::size_t>(list.last)].next) = edge;
  list.last = edge;
}

}  // namespace labmouse
