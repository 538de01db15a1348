#include "labmouse/mouse/wall_contexts.hpp"

#include <algorithm>

#include "labmouse/grid/wall_set.hpp"

namespace labmouse {
namespace {

/// The parallel wall that is `along` and `across` cells away from another one.
Wall parallel(Wall wall, int along, int across) {
  return wall.side == Heading::north ? Wall{{wall.cell.x + along, wall.cell.y + across}, wall.side}
                                     : Wall{{wall.cell.x + across, wall.cell.y + along}, wall.side};
}

/// The perpendicular wall on the far side, in the direction along, of the cell that is `along` and `across` cells away.
Wall crossing(Wall wall, int along, int across) {
  Wall other = parallel(wall, along, across);
  other.side = wall.side == Heading::north ? Heading::east : Heading::north;
  return other;
}

using Digits = std::array<int, 8>;

int number_of(const Digits& digits) {
  int number = 0;
  for (unsigned i = 8; i-- > 0;) number = 3 * number + digits[i];
  return number;
}

}  // namespace

std::array<Wall, 8> neighbours_of(Wall wall) {
  return {parallel(wall, -1, 0), crossing(wall, -1, 0), crossing(wall, -1, 1), parallel(wall, 1, 0),
          crossing(wall, 0, 0),  crossing(wall, 0, 1),  parallel(wall, 0, -1), parallel(wall, 0, 1)};
}

int folded_context(int context) {
  Digits d{};
  for (int& digit : d) {
    digit = context % 3;
    context /= 3;
  }
  const Digits left_right = {d[3], d[4], d[5], d[0], d[1], d[2], d[6], d[7]};
  const Digits near_far = {d[0], d[2], d[1], d[3], d[5], d[4], d[7], d[6]};
  const Digits both = {d[3], d[5], d[4], d[0], d[2], d[1], d[7], d[6]};
  return std::min({number_of(d), number_of(left_right), number_of(near_far), number_of(both)});
}

int context_of(Wall wall, const Knowledge& knowledge) {
  const std::array<Wall, 8> neighbours = neighbours_of(wall);
  Digits digits{};
  for (unsigned i = 0; i < neighbours.size(); ++i) {
    const WallState state =
        on_border(neighbours[i], knowledge.size()) ? WallState::closed : knowledge.state(neighbours[i]);
    digits[i] = state == WallState::unknown ? 0 : state == WallState::open ? 1 : 2;
  }
  return number_of(digits);
}

WallContexts::WallContexts(Size size) : size_(size), contexts_(static_cast<std::size_t>(2 * size.area()), 0) {
  WallSet::all(size).for_each([&](Wall wall) {
    const std::array<Wall, 8> neighbours = neighbours_of(wall);
    for (unsigned i = 0; i < neighbours.size(); ++i)
      if (on_border(neighbours[i], size)) add(wall, i, 2);
  });
}

}  // namespace labmouse
