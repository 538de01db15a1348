#include "labmouse/mouse/search_tree.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace labmouse {

SearchTree::SearchTree(Size size, int longest, TieOrder order, Reach reach)
    : size_(size), longest_(longest), order_(order), reach_(reach), nodes_(static_cast<std::size_t>(size.area())) {
  found_.reserve(nodes_.size());
}

void SearchTree::grow(const WallSet& passages, Pose root) { grow(passages, root, CellSet::all(size_)); }

void SearchTree::grow(const WallSet& passages, Pose root, const CellSet& through) {
  const auto open = [&](Cell cell, Heading direction) {
    int cells = 0;
    if (cell != root.cell && !through.contains(cell)) return cells;
    while (cells < longest_ && passages.contains(wall_at(neighbour(cell, direction, cells), direction))) ++cells;
    return cells;
  };
  grow_from(root, [&](Cell cell) {
    for (const Heading direction : order_.from(node(cell).heading)) {
      const int reach = open(cell, direction);
      for (int cells = 1; cells <= reach; ++cells)
        find(neighbour(cell, direction, reach_ == Reach::nearest_first ? cells : reach + 1 - cells), cell, direction);
    }
  });
}

void SearchTree::grow(const ConnectedCells& map, Pose root) {
  grow_from(root, [&](Cell cell) {
    for (const Cell next : map.of(cell)) find(next, cell, move_between(cell, next).direction);
  });
}

template <class FindFrom>
void SearchTree::grow_from(Pose root, FindFrom find_from) {
  nodes_.assign(nodes_.size(), Node{});
  found_.clear();
  node(root.cell) = {0, root.cell, root.heading};
  found_.push_back(root.cell);
  for (std::size_t next = 0; next < found_.size(); ++next) find_from(found_[next]);
}

void SearchTree::find(Cell cell, Cell before, Heading heading) {
  if (reaches(cell)) return;
  node(cell) = {node(before).distance + 1, before, heading};
  found_.push_back(cell);
}

int SearchTree::distance(Cell cell) const { return size_.contains(cell) ? node(cell).distance : unreachable; }

Cell SearchTree::before(Cell cell) const {
  assert(reaches(cell));
  return node(cell).before;
}

Cell SearchTree::first_towards(Cell cell) const {
  assert(reaches(cell) && distance(cell) > 0);
  while (distance(before(cell)) > 0) cell = before(cell);
  return cell;
}

Move move_between(Cell from, Cell to) {
  assert((from.x == to.x) != (from.y == to.y));
  if (from.x == to.x) return {to.y > from.y ? Heading::north : Heading::south, std::abs(to.y - from.y)};
  return {to.x > from.x ? Heading::east : Heading::west, std::abs(to.x - from.x)};
}

}  // namespace labmouse
