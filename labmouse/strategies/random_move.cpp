// random-move: chance alone.
//
// Limits: of three draws, the walls of a corridor waste two, and a dead end takes two turns the same way; so it seldom
// covers its share within the budget. Where the share cannot be reached it wanders for ever.
// Choices: the report prints nothing of this mouse; where its three strategies differ in the share, by the date of the
// program, this is the one of the report's listing, 5/6.
#include <array>

#include "labmouse/strategies/builtin_mice.hpp"
#include "labmouse/strategies/wanderer.hpp"

namespace labmouse {
namespace {

class RandomMove final : public Wanderer {
 public:
  using Wanderer::Wanderer;

 private:
  // A wall costs the step, the turn is made.
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
