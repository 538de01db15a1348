// The probability of unseen walls, counted in mazes by what is known of their surroundings.
#pragma once

#include <array>
#include <cstdint>

#include "labmouse/mouse/wall_contexts.hpp"

namespace labmouse {

/// Number of values of rim_context.
inline constexpr int rim_contexts = 24;

/// The reluctance to cross an unseen wall, -ln(1 - P(closed)) in units of 1/32 nat, 0 to 255. Integers from a table, so
/// that decisions do not depend on a mathematical library. `labmouse learn` makes them.
struct WallPrior {
  /// Of any wall, by its context.
  std::array<std::uint8_t, wall_contexts> walls;
  /// Of a wall on the rim of a goal room of 2×2 cells, by rim_context.
  std::array<std::uint8_t, rim_contexts> rim;

  friend bool operator==(const WallPrior&, const WallPrior&) = default;
};

/// Context of a wall on the rim of the goal room: how many of the eight have been seen open, and how many closed.
constexpr int rim_context(int open, int closed) { return (open > 2 ? 2 : open) * 8 + closed; }

}  // namespace labmouse
