// cautious: goes to a new neighbour if there is one, else to the least visited cell near.
//
// Limits: ignores where the goal is. With a share of cells to visit (`explore_frac`) near 1, most steps are
// spent on the last cells; if cells are unreachable, the share is never reached, and the budget ends.
// Choices: as the report's program does it. A visit is a step that begins in the cell; the start has one more. A
// neighbour is one cell away, in any direction. If all are visited, the mouse goes to the least visited cell that one
// known move leads to, up to three cells away; ties go to the first in the order of a Python 3.4 set. The share is of
// all cells of the maze, including those never seen.
#include <algorithm>
#include <array>
#include <optional>

#include "labmouse/chance/rng.hpp"
#include "labmouse/mouse/manhattan.hpp"
#include "labmouse/mouse/visits.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "labmouse/strategies/move_mapper.hpp"

namespace labmouse {
namespace {

class Cautious final : public MoveMapper {
 public:
  Cautious(const Briefing& briefing, const Settings& settings)
      : MoveMapper(briefing, settings),
        rng_(briefing.seed),
        visits_(briefing.size),
        cells_to_visit_(settings.real("explore_frac") * briefing.size.area()) {
    visits_.add(briefing.start.cell);
  }

 private:
  bool is_done() const override { return visited().count() >= cells_to_visit_; }

  Action choose() override {
    visits_.add(pose().cell);
    const auto cells = map().of(pose().cell);
    // No known move: turn to see the wall behind.
    if (cells.empty()) return Action::step(90, 0);
    if (const auto fresh = unvisited_neighbour()) return go_to(*fresh);
    return go_to(
        *std::min_element(cells.begin(), cells.end(), [&](Cell a, Cell b) { return visits_.of(a) < visits_.of(b); }));
  }

  /// A random unvisited cell that is one cell away; nullopt if there is none.
  std::optional<Cell> unvisited_neighbour() {
    std::array<Cell, 4> fresh;
    std::size_t count = 0;
    for (const Cell cell : map().of(pose().cell))
      if (manhattan(cell, pose().cell) == 1 && visits_.of(cell) == 0) fresh[count++] = cell;
    return count == 0 ? std::nullopt
                      : std::optional(fresh[static_cast<std::size_t>(rng_.below(static_cast<int>(count)))]);
  }

  Rng rng_;
  Visits visits_;
  double cells_to_visit_;
};

constexpr std::array cautious_parameters = {
    Parameter::real("explore_frac", "0", 0, 1, "Share of all cells to visit before the reset."),
    table_order,
};

}  // namespace

constinit const BuiltinMouse cautious_mouse = {
    .name = "cautious",
    .summary = "goes to a random new neighbour, else to the least visited cell near",
    .method =
        "Moves to a random neighbour that it has not visited, one cell, so that it passes nothing unseen; or, if it "
        "has visited all of them, to the least visited of the cells that one known move leads to. Once it has entered "
        "the goal and visited a share of all cells, it resets and takes the shortest route that it has seen.",
    .source = "CautiousBot in Edward Kish, section 4.3 (the third report).",
    .parameters = cautious_parameters,
    .make = [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<Cautious>(briefing, settings);
    },
    .uses_chance = BuiltinMouse::always,
};

}  // namespace labmouse
