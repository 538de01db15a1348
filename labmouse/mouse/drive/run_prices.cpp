#include "labmouse/mouse/drive/run_prices.hpp"

#include <algorithm>
#include <string_view>

namespace labmouse {
namespace {

/// The time through a corridor that begins northwards, repeats a pattern of headings N, E, S, and ends eastwards.
DriveTime time_through(FastestRoutes& routes, std::string_view pattern, int times) {
  WallSet passages;
  Cell cell{0, 0};
  const auto go = [&](Heading heading) {
    passages.insert(wall_at(cell, heading));
    cell = neighbour(cell, heading);
  };
  go(Heading::north);
  for (int i = 0; i < times; ++i)
    for (const char letter : pattern)
      go(letter == 'N' ? Heading::north : letter == 'E' ? Heading::east : Heading::south);
  go(Heading::east);
  routes.fill(passages, CellSet::of(cell));
  return routes.time_from({{0, 0}, Heading::north});
}

}  // namespace

RunPrices run_prices_of(FastestRoutes& routes) {
  constexpr int few = 1, many = 3;
  const auto period = [&](std::string_view pattern) {
    return (time_through(routes, pattern, many) - time_through(routes, pattern, few)) / (many - few) / 1000;
  };
  // Two straights and two turns; six and two; two opposite turns; four straights, two turns, and each of them again.
  const int narrow = period("NNEE"), wide = period("NNNNEEEE"), stairs = period("NE"), loops = period("NNNESSSE");
  RunPrices prices;
  prices.straight = std::max((wide - narrow) / 4, 1);
  prices.turn = std::max((narrow - 2 * prices.straight) / 2, 1);
  prices.opposite = std::max(stairs / 2, 1);
  prices.again = std::max((loops - 4 * prices.straight - 2 * prices.turn) / 2, 1);
  return prices;
}

}  // namespace labmouse
