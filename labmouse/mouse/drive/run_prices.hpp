// What a run costs, cell by cell: the planner of a robot in four numbers.
#pragma once

#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {

/// What a speed run takes, in milliseconds for each edge that it crosses from cell to cell. Sums of these explain the
/// times of fastest routes in contest mazes to R² = 0.997 (260 mazes, `classic`, November 2026): what a run gains on
/// straights and loses before turns is much the same everywhere.
struct RunPrices {
  int straight = 1;
  int turn = 1;      ///< a quarter turn behind a straight
  int opposite = 1;  ///< right behind a turn to the other side: together they are a diagonal
  int again = 1;     ///< right behind a turn to the same side
};

/// By how much longer the fastest routes through some corridors take where a pattern of straights and turns comes once
/// more. Fills the routes, which must be those of a maze of run_prices_side or more each way.
RunPrices run_prices_of(FastestRoutes& routes);
inline constexpr int run_prices_side = 16;

}  // namespace labmouse
