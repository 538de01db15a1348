#include "labmouse/lab/learn/corridor_table.hpp"

#include <algorithm>
#include <cassert>

namespace labmouse {

void write_corridors(const Maze& maze, int pitch, std::span<Corridors> table) {
  const Size size = maze.size();
  assert(pitch >= size.width && table.size() >= static_cast<std::size_t>(pitch * size.height));
  std::fill(table.begin(), table.end(), 0U);
  const auto at = [&](Cell cell) -> Corridors& { return table[static_cast<std::size_t>(cell.y * pitch + cell.x)]; };
  // A corridor is one cell longer than that of the next cell, so the next cell has to be processed first.
  const auto extend = [&](Cell cell, Heading heading) {
    if (!maze.is_open(cell, heading)) return;
    const auto cells = static_cast<unsigned>(corridor(at(neighbour(cell, heading)), heading)) + 1;
    at(cell) |= cells << (8 * static_cast<unsigned>(heading));
  };
  for (int index = 0; index < size.area(); ++index) {
    extend(size.cell_at(index), Heading::south);
    extend(size.cell_at(index), Heading::west);
  }
  for (int index = size.area() - 1; index >= 0; --index) {
    extend(size.cell_at(index), Heading::north);
    extend(size.cell_at(index), Heading::east);
  }
  maze.goals().for_each([&](Cell cell) { at(cell) |= goal_mark; });
}

}  // namespace labmouse
