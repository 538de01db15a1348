// dead-end: random turns, but only to free cells.
//
// Limits: it can stay in a corridor or a loop for long. If the share of cells to mark (`coverage`) cannot be
// reached, it never resets.
// Choices: as for random-move.
#include <array>

#include "labmouse/strategies/builtin_mice.hpp"
#include "labmouse/strategies/wanderer.hpp"

namespace labmouse {
namespace {

class DeadEnd final : public Wanderer {
 public:
  using Wanderer::Wanderer;

 private:
  Action wander() override { return in_dead_end() ? Action::step(90, 0) : draw_a_free_cell(); }
};

constexpr std::array dead_end_parameters = {wanderers_coverage, wanderers_search};

}  // namespace

constinit const BuiltinMouse dead_end_mouse = {
    .name = "dead-end",
    .summary = "random turns to free cells; turns out of dead ends",
    .method =
        "Like random-move, but draws the turn again while a wall is in the way; in a dead end it turns right on the "
        "spot, and marks nothing there.",
    .source =
        "Random move with dead end detection, in the fifth report, \"Plot and Navigate a Virtual Maze\", Algorithms "
        "and Techniques; its benchmark among explorers.",
    .parameters = dead_end_parameters,
    .make = [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<DeadEnd>(briefing, settings);
    },
    .uses_chance = BuiltinMouse::always,
};

}  // namespace labmouse
