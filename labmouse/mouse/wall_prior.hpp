// How likely a wall is that has not been seen: counted in mazes, by what is known of its surroundings.
#pragma once

#include <array>
#include <cstdint>

#include "labmouse/mouse/wall_contexts.hpp"

namespace labmouse {

/// So many numbers does rim_context give.
inline constexpr int rim_contexts = 24;

/// What crossing an unseen wall is worth avoiding: its reluctance, -ln(1 - P(closed)) in 1/32, 0 to 255. Integers that
/// a table gives, so that no mathematical library decides what a mouse does. `labmouse learn` makes them.
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
