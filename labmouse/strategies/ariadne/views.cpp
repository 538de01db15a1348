#include "labmouse/strategies/ariadne/views.hpp"

namespace labmouse::ariadne {

Viewpoint Views::viewpoint(Wall wall) const {
  Viewpoint nearest;
  for (const Heading side : {wall.side, opposite(wall.side)}) {
    Cell cell = side == wall.side ? wall.cell : neighbour(wall.cell, wall.side);
    bool more = true;
    for (int away = 0; more && away < sight_; ++away, cell = neighbour(cell, opposite(side))) {
      if (const int travel = travel_.at(cell); travel < nearest.travel) nearest = {cell, travel};
      more = knowledge_.open().contains(wall_at(cell, opposite(side)));
    }
  }
  return nearest;
}

int Views::unseen_from(Cell from, const WallPrices& prices) const {
  int unseen = 0;
  for (const Heading direction : all_headings) {
    Cell cell = from;
    int away = 0;
    for (; away < sight_ && knowledge_.open().contains(wall_at(cell, direction)); ++away)
      cell = neighbour(cell, direction);
    if (away == sight_) continue;
    const Wall wall = wall_at(cell, direction);
    if (knowledge_.state(wall) == WallState::unknown && prices.passable(wall)) ++unseen;
  }
  return unseen;
}

std::optional<Viewpoint> Views::nearest_goal() const {
  std::optional<Viewpoint> nearest;
  goals_.for_each([&](Cell cell) {
    const int travel = travel_.at(cell);
    if (travel < unreachable && (!nearest || travel < nearest->travel)) nearest = Viewpoint{cell, travel};
  });
  return nearest;
}

}  // namespace labmouse::ariadne
