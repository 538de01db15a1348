#include "labmouse/mouse/knowledge.hpp"

#include <algorithm>
#include <cassert>

namespace labmouse {

Knowledge::Knowledge(Size size, int sight) : size_(size), sight_(sight), possible_(WallSet::all(size)) {
  assert(size.valid() && sight > 0);
}

WallState Knowledge::state(Wall wall) const {
  if (open_.contains(wall)) return WallState::open;
  return possible_.contains(wall) ? WallState::unknown : WallState::closed;
}

WallSet Knowledge::unknown() const {
  WallSet walls = possible_;
  walls -= open_;
  return walls;
}

bool Knowledge::knows(Cell cell) const {
  const auto known = [&](Heading side) {
    const Wall wall = wall_at(cell, side);
    return open_.contains(wall) || !possible_.contains(wall);
  };
  return std::all_of(all_headings.begin(), all_headings.end(), known);
}

CellSet Knowledge::known_cells() const {
  const WallSet unseen = unknown();
  CellSet cells = CellSet::all(size_);
  for (int y = 0; y < size_.height; ++y) {
    const std::uint64_t east = unseen.east().row(y), north = unseen.north().row(y);
    const std::uint64_t south = y > 0 ? unseen.north().row(y - 1) : 0;
    cells.set_row(y, cells.row(y) & ~(north | south | east | east << 1U));
  }
  return cells;
}

bool Knowledge::learn(Pose pose, Sighting sighting) {
  for (const int side : {-1, 0, 1})
    if (!agrees({pose.cell, turned(pose.heading, side)}, sighting.towards(side))) return false;
  for (const int side : {-1, 0, 1}) learn_corridor({pose.cell, turned(pose.heading, side)}, sighting.towards(side));
  return true;
}

void Knowledge::learn(Wall wall, bool open) {
  assert(!on_border(wall, size_) && state(wall) == WallState::unknown);
  if (open)
    open_.insert(wall);
  else
    possible_.erase(wall);
}

void Knowledge::forget(Wall wall) {
  assert(!on_border(wall, size_));
  open_.erase(wall);
  possible_.insert(wall);
}

bool Knowledge::agrees(Pose pose, int open_cells) const {
  if (open_cells < 0 || open_cells >= max_side || open_cells > sight_) return false;
  Cell cell = pose.cell;
  for (int passed = 0; passed < open_cells; ++passed) {
    if (!possible_.contains(wall_at(cell, pose.heading))) return false;
    cell = neighbour(cell, pose.heading);
  }
  return open_cells == sight_ || !open_.contains(wall_at(cell, pose.heading));
}

void Knowledge::learn_corridor(Pose pose, int open_cells) {
  Cell cell = pose.cell;
  for (int passed = 0; passed < open_cells; ++passed) {
    open_.insert(wall_at(cell, pose.heading));
    cell = neighbour(cell, pose.heading);
  }
  if (open_cells == sight_) return;
  // The wall that ends the corridor; on the border there is nothing to learn.
  if (const Wall end = wall_at(cell, pose.heading); !on_border(end, size_)) possible_.erase(end);
}

}  // namespace labmouse
