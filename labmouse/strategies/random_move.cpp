// random-move: random turns, regardless of walls.
//
// Limits: in a corridor, two of three draws hit a wall; a dead end takes two turns in the same direction. So it seldom
// marks the share of cells (`coverage`) within the budget. If the share cannot be reached, it never resets.
// Choices: the report prints no scores of this mouse. Versions of its program differ in the share; 5/6 is that of the
// report's listing.
#include <array>

#include "labmouse/strategies/builtin_mice.hpp"
#include "labmouse/strategies/wanderer.hpp"

namespace labmouse {
namespace {

class RandomMove final : public Wanderer {
 public:
  using Wanderer::Wanderer;

 private:
  // If a wall is in the way, the step only turns.
  Action wander() override {
    const int quarters = draw();
    return Action::step(90 * quarters, is_free(quarters) ? 1 : 0);
  }
};

constexpr std::array random_move_parameters = {wanderers_coverage, wanderers_search};

}  // namespace

constinit const BuiltinMouse random_move_mouse = {
    .name = "random-move",
    .summary = "random turns, whatever it sees",
    .method =
        "At each step a random turn of -90, 0 or 90 degrees, and one cell ahead where no wall is in the way; it "
        "ignores whatever else it sees. A cell is marked when it stands in it. Once it has marked a goal and a share "
        "of all cells, it resets, and plans its path by a textbook search over the passages that it walked.",
    .source = "Random move, in the fifth report, \"Plot and Navigate a Virtual Maze\", Algorithms and Techniques.",
    .parameters = random_move_parameters,
    .make = [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<RandomMove>(briefing, settings);
    },
    .uses_chance = BuiltinMouse::always,
};

}  // namespace labmouse
