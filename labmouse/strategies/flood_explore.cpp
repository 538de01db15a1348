// flood-explore: floods to the goal, then to every cell that it has not visited.
//
// Limits: explores all cells regardless of the budget. In large mazes, and in mazes with an unreachable cell, it never
// resets. It counts cells, not steps, so its route is seldom the fastest even with the complete map.
// Choices: the report does not define "farthest". Distances to the mouse, the goal or the start do not reproduce its
// scores; a list of points [column, row] in reverse order gives all three exactly (33.733 as 412 steps and 20, 43.367
// as 551 and 25, 52.4 as 822 and 25). So the easternmost column comes first, and in it the northernmost cell. The same
// scores require that the speed run prefers the end of the tie order (flood-block determines that order); some other
// orders, such as ahead, left, right, give the same scores. For an unreachable cell (the report's mazes have none) all
// distances are equal, so each step takes the first direction in the order, and the search never ends.
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
