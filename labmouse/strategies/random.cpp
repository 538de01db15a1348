// random: the benchmark that every other mouse should beat.
//
// Limits: the speed run is random, too, so it seldom ends within the budget.
// Choices: a move may go backwards, and a cell within range is any that one move can reach through known passages.
#include <array>

#include "labmouse/strategies/builtin_mice.hpp"
#include "labmouse/strategies/move_mapper.hpp"
#include "labmouse/strategies/random_walk.hpp"

namespace labmouse {
namespace {

class RandomMouse final : public MoveMapper {
 public:
  RandomMouse(const Briefing& briefing, const Settings& settings)
      : MoveMapper(briefing, settings), walk_(briefing, settings.whole("stride")) {}

 private:
  Action choose() override {
    const Cell next = walk_.next(pose().cell, map().of(pose().cell));
    // No known move: turn to see the wall behind.
    return next == pose().cell ? Action::step(90, 0) : go_to(next);
  }
  Action race() override {
    look();
    return choose();
  }

  RandomWalk walk_;
};

constexpr std::array random_parameters = {random_walk_stride, table_order};

}  // namespace

constinit const BuiltinMouse random_mouse = {
    .name = "random",
    .summary = "random moves through known passages, in both runs",
    .method =
        "At each step it goes to one of the cells that it can reach in one move through walls known to be open, all "
        "equally likely. When it first enters the goal, it resets and continues in the same way.",
    .source = "BenchmarkBot in Edward Kish, \"Plot and Navigate a Virtual Maze\", section 4.1 (the third report).",
    .parameters = random_parameters,
    .make = [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<RandomMouse>(briefing, settings);
    },
    .uses_chance = BuiltinMouse::always,
};

}  // namespace labmouse
