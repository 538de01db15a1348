// random: the benchmark that every other mouse should beat.
//
// Method: at each step one of the cells that can be reached by one move through walls known to be open, all equally
// likely; at the first entry of the goal it resets and goes on in the same way.
// Limits: the second run is left to chance too, so it seldom ends within the budget.
// Source: BenchmarkBot in Edward Kish, "Plot and Navigate a Virtual Maze", section 4.1 (the third report).
#include <algorithm>
#include <array>

#include "labmouse/chance/dice.hpp"
#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/known_moves.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

class RandomMouse final : public Explorer {
 public:
  RandomMouse(const Briefing& briefing, const Settings& settings)
      : Explorer(briefing), dice_(briefing.seed), stride_(std::min(settings.whole("stride"), briefing.motion.longest)) {}

 private:
  Action explore() override { return goal_entered() ? Action::reset() : wander(); }
  Action race() override { return wander(); }

  Action wander() {
    const KnownMoves moves(knowledge().open(), pose().cell, stride_);
    // Nowhere to go: look at the wall behind.
    if (moves.empty()) return Action::step(90, 0);
    const Move& move = moves[dice_.below(moves.count())];
    return move_in(pose().heading, move.direction, move.cells);
  }

  Dice dice_;
  int stride_;
};

constexpr std::array parameters = {
    Parameter{"stride", ParameterType::whole, "3", 1, Motion::max_longest, "", "longest move, in cells; the rules' own limit holds too"},
};

}  // namespace

const RosterEntry random_mouse = {
    "random", "random moves through known passages, in both runs", parameters,
    [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<RandomMouse>(briefing, settings);
    },
    RosterEntry::always};

}  // namespace labmouse
