// manhattan: goes to the unvisited cell with the least Manhattan distance to the goal.
//
// Limits: it crosses the maze again and again if two regions near the goal are both closed, and seldom explores the
// edge, where the way to the goal often is.
// Choices: by a sign error, the report's program measures to the point one cell south-west of the goal's middle. That
// is kept, because the printed scores depend on it. Ties go to the first cell in the order of a Python 3.4 map
// (MoveMapper).
#include <algorithm>
#include <array>
#include <cstdlib>

#include "labmouse/strategies/builtin_mice.hpp"
#include "labmouse/strategies/seeker.hpp"

namespace labmouse {
namespace {

class Manhattan final : public Seeker {
 public:
  Manhattan(const Briefing& briefing, const Settings& settings) : Seeker(briefing, settings) {
    x_ = briefing.size.width;
    y_ = briefing.size.height;
    briefing.goals.for_each([&](Cell goal) {
      x_ = std::min<int>(x_, goal.x);
      y_ = std::min<int>(y_, goal.y);
    });
  }

 private:
  /// Manhattan distance, in half cells.
  int cost(const SearchTree&, Cell cell) const override {
    return std::abs(2 * (cell.x - x_) + 1) + std::abs(2 * (cell.y - y_) + 1);
  }

  int x_, y_;  ///< the goal's lowest column and row
};

constexpr std::array manhattan_parameters = {table_order};

}  // namespace

constinit const BuiltinMouse manhattan_mouse = {
    .name = "manhattan",
    .summary = "goes to the unvisited cell that looks nearest to the goal",
    .method =
        "Of the cells that it has seen but not visited, it goes to the one with the smallest Manhattan distance to a "
        "point, by the shortest route, and chooses again. By an error of sign in the original, the point lies one cell "
        "south-west of the middle of the goal. When it enters the goal, it resets and takes the shortest route that it "
        "has seen.",
    .source = "ManhattanBot in Edward Kish, section 4.4 (the third report).",
    .parameters = manhattan_parameters,
    .make = [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<Manhattan>(briefing, settings);
    },
};

}  // namespace labmouse
