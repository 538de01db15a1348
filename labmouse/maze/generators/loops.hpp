// Random draws, and opening of random walls, which gives a perfect maze its loops.
#pragma once

#include <utility>
#include <vector>

#include "labmouse/chance/rng.hpp"
#include "labmouse/maze/generators/generator.hpp"

namespace labmouse {

/// Removes and returns a random member of the lots, which must not be empty.
template <class T>
T draw(std::vector<T>& lots, Rng& rng) {
  std::swap(lots[static_cast<std::size_t>(rng.below(static_cast<int>(lots.size())))], lots.back());
  const T drawn = lots.back();
  lots.pop_back();
  return drawn;
}

/// The walls of a set as a vector to draw from.
inline std::vector<Wall> lots_of(const WallSet& walls) {
  std::vector<Wall> lots;
  walls.for_each([&](Wall wall) { lots.push_back(wall); });
  return lots;
}

/// Opens a share (order.loops) of the inner walls that still stand, rounded to the nearest number, in random order.
/// Skips walls for which may_open(draft, wall) is false. The random numbers depend on the order's seed alone, so a
/// larger share opens the same walls and more.
template <class MayOpen>
void open_loops(MazeDraft& draft, const GeneratorOrder& order, MayOpen may_open) {
  Rng rng(seed_for(order.seed, "loops"));
  WallSet standing = WallSet::all(order.size);
  standing -= draft.open_walls();
  std::vector<Wall> lots = lots_of(standing);
  int to_open = (static_cast<int>(lots.size()) * order.loops + 500) / 1000;
  while (to_open > 0 && !lots.empty()) {
    const Wall wall = draw(lots, rng);
    if (!may_open(draft, wall)) continue;
    draft.open(wall.cell, wall.side);
    --to_open;
  }
}

/// The same, where any wall may be opened.
inline void open_loops(MazeDraft& draft, const GeneratorOrder& order) {
  open_loops(draft, order, [](const MazeDraft&, Wall) { return true; });
}

}  // namespace labmouse
