#include "labmouse/mouse/connected_cells.hpp"

#include <algorithm>

namespace labmouse {

ConnectedCells::ConnectedCells(Size size, int longest, CellOrder order)
    : size_(size),
      longest_(longest),
      most_(4 * static_cast<std::size_t>(longest)),
      map_(size, order, CellTable::map, CellKey::column_row),
      set_(size, order, CellTable::set, CellKey::column_row),
      connected_(most_ * static_cast<std::size_t>(size.area())),
      counts_(static_cast<std::size_t>(size.area())),
      settled_(static_cast<std::size_t>(size.area())) {}

void ConnectedCells::learn(Pose pose, const Sighting& seen) {
  for (const int side : {-1, 0, 1}) {
    const Heading direction = turned(pose.heading, side);
    const int cells = seen.towards(side);
    for (int near = 0; near < cells; ++near)
      for (int far = near + 1; far <= std::min(cells, near + longest_); ++far) {
        connect(neighbour(pose.cell, direction, near), neighbour(pose.cell, direction, far));
        connect(neighbour(pose.cell, direction, far), neighbour(pose.cell, direction, near));
      }
  }
}

void ConnectedCells::connect(Cell from, Cell to) {
  const auto index = static_cast<std::size_t>(size_.index(from));
  const std::span<const Cell> before = of(from);
  const bool is_new = std::find(before.begin(), before.end(), to) == before.end();
  if (!is_new && settled_[index]) return;
  if (before.empty()) map_.insert(from);
  set_.copy(before);
  set_.insert(to);
  Cell* next = connected_.data() + index * most_;
  bool same = !is_new;
  set_.for_each([&](Cell cell) {
    same = same && *next == cell;
    *next++ = cell;
  });
  counts_[index] = static_cast<std::uint8_t>(next - (connected_.data() + index * most_));
  settled_[index] = same;
}

}  // namespace labmouse
