// flood-block: floods to the goal; its speed run uses only visited cells.
//
// Limits: the speed run follows visited cells only, even if an unvisited shortcut was seen; loops back to a visited
// cell are skipped. It counts cells, not steps, so it prefers a crooked way to a straight one of two cells more.
// Choices: The tie order wsen is the only one of the 48 that gives the reported score in all three mazes (25.4 as 42
// steps and 24, 48 as 90 and 45, 40.767 as 83 and 38), and only where the flood starts from the north-western cell of
// the goal and the search run ends in that cell alone. The moves that the speed run prefers, and the direction of turns
// on the spot, do not affect these scores. The first is determined by flood-explore; the second is a right turn. In
// other goals the mouse takes the northernmost cell of the westernmost column; if that is unreachable, the next one to
// the south or east, which the report does not specify.
#include <array>

#include "labmouse/strategies/builtin_mice.hpp"
#include "labmouse/strategies/cell_flood.hpp"

namespace labmouse {
namespace {

class FloodBlock final : public CellFlood {
 public:
  using CellFlood::CellFlood;

 private:
  Action after_goal() override { return Action::reset(); }
  WallSet map() const override { return passages_among(visited(), knowledge().open()); }
};

constexpr std::array flood_block_parameters = {cell_flood_ties};

}  // namespace

constinit const BuiltinMouse flood_block_mouse = {
    .name = "flood-block",
    .summary = "flood fill cell by cell to the goal; the speed run uses only visited cells",
    .method =
        "Flood fill cell by cell until the goal is found, then the reset. For the speed run, only the passages "
        "between visited cells stay on the map: the mouse trusts no cell that it has not stood in.",
    .source =
        "Method 2, \"block out\", in Jonathan Lee, \"Plot and Navigate a Virtual Maze\", 2016 (the first report).",
    .parameters = flood_block_parameters,
    .make = [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<FloodBlock>(briefing, TieOrder(settings.choice("ties")));
    },
};

}  // namespace labmouse
