// random: the benchmark that every other mouse should beat.
//
// Limits: the second run is left to chance too, so it seldom ends within the budget.
// Choices: a move may go backwards, and a cell within range is any that one move can reach through known passages.
#include <array>

#include "labmouse/mouse/explorer.hpp"
#include "labmouse/strategies/random_walk.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

constexpr std::string_view method =
    "At each step it goes to one of the cells that it can reach in one move through walls known to be open, all "
    "equally likely. When it first enters the goal, it resets and continues in the same way.";

constexpr std::string_view source =
    "BenchmarkBot in Edward Kish, \"Plot and Navigate a Virtual Maze\", section 4.1 (the third report).";

class RandomMouse final : public Explorer {
 public:
  RandomMouse(const Briefing& briefing, const Settings& settings)
      : Explorer(briefing), walk_(briefing, settings.whole("stride")) {}

 private:
  Action explore() override { return goal_entered() ? Action::reset() : race(); }
  Action race() override { return walk_.step(knowledge().open(), pose()); }

  RandomWalk walk_;
};

constexpr std::array parameters = {random_walk_stride};

}  // namespace

constinit const RosterEntry random_mouse = {
    "random",
    "random moves through known passages, in both runs",
    method,
    source,
    parameters,
    [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<RandomMouse>(briefing, settings);
    },
    RosterEntry::always};

}  // namespace labmouse
