// The mouse that docs/how-to/add-a-strategy.md shows, as it stands there.
#include <gtest/gtest.h>

#include "labmouse/contest/score.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {

extern const BuiltinMouse nearest_unseen_mouse;

TEST(TemplateMouse, SolvesPerfectMazesByTheirOnlyRoute) {
  const Rules rules;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Maze maze = wilson_generator.make({{8, 8}, seed, 0});
    const auto mouse = nearest_unseen_mouse.make(brief(maze, rules, seed), Settings(nearest_unseen_mouse.parameters));
    const Score result = score(run(maze, rules, *mouse), rules);
    ASSERT_EQ(result.outcome, Outcome::finished) << "seed " << seed;
    EXPECT_EQ(result.speed_steps, *bound_of(maze, rules).optimum);
  }
}

TEST(TemplateMouse, StopsSoonerWithASmallerShare) {
  const Rules rules;
  const Maze maze = wilson_generator.make({{8, 8}, 1, 0});
  const auto steps_with = [&](std::string_view share) {
    Settings settings(nearest_unseen_mouse.parameters);
    settings.set("share", share);
    const auto mouse = nearest_unseen_mouse.make(brief(maze, rules, 1), settings);
    return score(run(maze, rules, *mouse), rules).search_steps;
  };
  EXPECT_LT(steps_with("0"), steps_with("1"));
}

}  // namespace labmouse
