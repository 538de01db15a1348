// random-then-shortest: explores at random, then takes the shortest seen route.
//
// Limits: in larger mazes the walk often does not find the goal within the budget.
// Choices: a cell "within range" is any that one move can reach, also backwards; visited cells are not excluded.
#include <array>

#include "labmouse/strategies/builtin_mice.hpp"
#include "labmouse/strategies/move_mapper.hpp"
#include "labmouse/strategies/random_walk.hpp"

namespace labmouse {
namespace {

class RandomThenShortest final : public MoveMapper {
 public:
  RandomThenShortest(const Briefing& briefing, const Settings& settings)
      : MoveMapper(briefing, settings), walk_(briefing, settings.whole("stride")) {}

 private:
  Action choose() override {
    const Cell next = walk_.next(pose().cell, map().of(pose().cell));
    // No known move: turn to see the wall behind.
    return next == pose().cell ? Action::step(90, 0) : go_to(next);
  }

  RandomWalk walk_;
};

constexpr std::array random_then_shortest_parameters = {random_walk_stride, table_order};

}  // namespace

constinit const BuiltinMouse random_then_shortest_mouse = {
    .name = "random-then-shortest",
    .summary = "random moves to the goal, then the shortest route that it has seen",
    .method =
        "At each step of the search run it goes to one of the cells that it can reach in one move through walls "
        "known to be open, all equally likely. When it first enters the goal, it resets and takes the shortest route "
        "that it has seen.",
    .source = "BetterBenchmarkBot in Edward Kish, section 4.2 (the third report).",
    .parameters = random_then_shortest_parameters,
    .make = [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<RandomThenShortest>(briefing, settings);
    },
    .uses_chance = BuiltinMouse::always,
};

}  // namespace labmouse
