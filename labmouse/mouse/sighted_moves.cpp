#include "labmouse/mouse/sighted_moves.hpp"

#include <algorithm>

namespace labmouse {

SightedMoves::SightedMoves(Size size, int longest)
    : size_(size), longest_(longest), known_(static_cast<std::size_t>(size.area())) {}

void SightedMoves::learn(Pose pose, const Sighting& seen) {
  for (const int side : {-1, 0, 1}) learn_corridor(pose.cell, turned(pose.heading, side), seen.towards(side));
}

void SightedMoves::learn_corridor(Cell from, Heading direction, int cells) {
  for (int away = 0; away <= cells; ++away) {
    const Cell cell = neighbour(from, direction, away);
    widen(cell, direction, cells - away);
    widen(cell, opposite(direction), away);
  }
}

void SightedMoves::widen(Cell from, Heading direction, int cells) {
  auto& known = known_[static_cast<std::size_t>(size_.index(from))][static_cast<unsigned>(direction)];
  known = std::max(known, static_cast<std::uint8_t>(std::min(cells, longest_)));
}

}  // namespace labmouse
