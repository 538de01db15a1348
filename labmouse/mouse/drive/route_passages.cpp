#include "labmouse/mouse/drive/route_passages.hpp"

#include <cstdint>

namespace labmouse {
namespace {

/// The cells straight beyond the goals, where a mouse may stop, and the goals themselves.
CellSet cells_to_stop_in(Size size, const WallSet& passages, const CellSet& goals) {
  CellSet cells = goals;
  goals.for_each([&](Cell goal) {
    for (const Heading heading : all_headings)
      for (Cell cell = goal; !on_border(wall_at(cell, heading), size) && passages.contains(wall_at(cell, heading));) {
        cell = neighbour(cell, heading);
        cells.insert(cell);
      }
  });
  return cells;
}

}  // namespace

WallSet passages_of_routes(Size size, WallSet passages, Cell start, const CellSet& goals) {
  CellSet ends = cells_to_stop_in(size, passages, goals);
  ends.insert(start);
  CellSet north = passages.north(), east = passages.east();
  for (bool any = true; any;) {
    any = false;
    for (int y = 0; y < size.height;) {
      const std::uint64_t to_north = north.row(y), to_south = y > 0 ? north.row(y - 1) : 0;
      const std::uint64_t to_east = east.row(y), to_west = east.row(y) << 1;
      const std::uint64_t two =
          (to_north & to_south) | (to_east & to_west) | ((to_north | to_south) & (to_east | to_west));
      const std::uint64_t dead = (to_north | to_south | to_east | to_west) & ~two & ~ends.row(y);
      if (dead == 0) {
        ++y;
        continue;
      }
      any = true;
      north.set_row(y, to_north & ~dead);
      if (y > 0) north.set_row(y - 1, to_south & ~dead);
      east.set_row(y, to_east & ~dead & ~(dead >> 1));
    }
  }
  return WallSet::of(north, east);
}

}  // namespace labmouse
