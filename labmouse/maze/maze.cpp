#include "labmouse/maze/maze.hpp"

#include <cassert>

namespace labmouse {

MazeDraft::MazeDraft(Size size, Inside inside) : size_(size) {
  assert(size.valid());
  if (inside == Inside::open) open_ = WallSet::all(size);
}

bool MazeDraft::is_open(Cell cell, Heading side) const { return open_.contains(wall_at(cell, side)); }

void MazeDraft::open(Cell cell, Heading side) {
  assert(size_.contains(cell));
  if (const Wall wall = wall_at(cell, side); !on_border(wall, size_)) open_.insert(wall);
}

void MazeDraft::close(Cell cell, Heading side) {
  assert(size_.contains(cell));
  if (const Wall wall = wall_at(cell, side); !on_border(wall, size_)) open_.erase(wall);
}

void MazeDraft::set_start(Cell cell, Heading heading) {
  assert(size_.contains(cell));
  start_ = cell;
  start_heading_ = heading;
}

void MazeDraft::add_goal(Cell cell) {
  assert(size_.contains(cell));
  goals_.insert(cell);
}

CellSet centre_of(Size size) {
  CellSet cells;
  for (int y = (size.height - 1) / 2; y <= size.height / 2; ++y)
    for (int x = (size.width - 1) / 2; x <= size.width / 2; ++x) cells.insert({x, y});
  return cells;
}

Maze::Maze(const MazeDraft& draft)
    : size_(draft.size()),
      open_(draft.open_walls()),
      start_(draft.start()),
      start_heading_(draft.start_heading()),
      goals_(draft.goals().empty() ? centre_of(draft.size()) : draft.goals()) {}

int Maze::corridor(Cell cell, Heading heading) const {
  int cells = 0;
  while (is_open(cell, heading)) {
    cell = neighbour(cell, heading);
    ++cells;
  }
  return cells;
}

Maze Maze::with_start(Cell cell, Heading heading) const {
  assert(size_.contains(cell));
  Maze other = *this;
  other.start_ = cell;
  other.start_heading_ = heading;
  return other;
}

Maze Maze::with_goals(const CellSet& goals) const {
  assert(!goals.empty());
  Maze other = *this;
  other.goals_ = goals;
  return other;
}

}  // namespace labmouse
