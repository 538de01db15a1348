// flood-explore: floods to the goal, then to every cell that it has not visited.
//
// Limits: buys the whole map at any price and does not watch the budget: in large mazes it never resets, and in mazes
// with a cell that cannot be reached it looks for that one for ever. Counts cells, not steps, so even on the whole map
// its way is seldom the fastest.
// Choices: What is farthest? Distances to the mouse, the goal or the start, in cells, straight or as Manhattan's,
// sorted once or anew at each cell or step, miss the reported scores; a list of points [column, row] sorted backwards
// gives all three exactly (33.733 as 412 steps and 20, 43.367 as 551 and 25, 52.4 as 822 and 25). So the easternmost
// column comes first, and in it the northernmost cell: far from the start's corner. The same scores settle that the
// speed run prefers the end of the tie order, which flood-block alone settles; ahead before left before right, and a
// few more, would do as well. Where an unvisited cell cannot be reached (the report's mazes have none), all distances
// to it are equal, and the first direction in order wins at each step, for ever.
#include <array>
#include <optional>

#include "labmouse/strategies/builtin_mice.hpp"
#include "labmouse/strategies/cell_flood.hpp"

namespace labmouse {
namespace {

class FloodExplore final : public CellFlood {
 public:
  using CellFlood::CellFlood;

 private:
  Action after_goal() override {
    const auto target = farthest_unvisited();
    return target ? step_towards(*target) : Action::reset();
  }

  std::optional<Cell> farthest_unvisited() const {
    for (int x = briefing().size.width - 1; x >= 0; --x)
      for (int y = briefing().size.height - 1; y >= 0; --y)
        if (!visited().contains({x, y})) return Cell{x, y};
    return std::nullopt;
  }

  WallSet map() const override { return knowledge().open(); }
};

constexpr std::array flood_explore_parameters = {cell_flood_ties};

}  // namespace

constinit const BuiltinMouse flood_explore_mouse = {
    .name = "flood-explore",
    .summary = "flood fill cell by cell to the goal and then to every cell",
    .method =
        "Flood fill cell by cell until the goal is found, then in the same way to each unvisited cell, the farthest "
        "first; reset when none is left. The speed run is a shortest path in cells, divided into strides.",
    .source =
        "Method 1, \"exploration of maze after goal\", in Jonathan Lee, \"Plot and Navigate a Virtual Maze\", 2016 "
        "(the first report).",
    .parameters = flood_explore_parameters,
    .make = [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<FloodExplore>(briefing, TieOrder(settings.choice("ties")));
    },
};

}  // namespace labmouse
