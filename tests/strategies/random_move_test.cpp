#include <gtest/gtest.h>

#include <map>

#include "tests/strategies/wanderers.hpp"

namespace labmouse {
namespace {

TEST(RandomMove, DrawsEveryTurnWithEveryMovementEquallyOften) {
  const Maze open = Maze(MazeDraft({9, 9}, MazeDraft::Inside::open)).with_start({4, 3}, Heading::north);
  std::map<std::pair<int, int>, int> drawn;
  for (std::uint64_t seed = 1; seed <= 1200; ++seed) {
    const Action first = test::wander(random_move_mouse, open, seed, {}, 1).steps.front().action;
    ++drawn[{first.rotation, first.movement}];
  }
  EXPECT_EQ(drawn.size(), 12U);
  for (const auto& [action, times] : drawn) EXPECT_NEAR(times, 100, 40) << action.first << ' ' << action.second;
}

TEST(RandomMove, AlsoTurnsAndStaysWhereWallsAreOnAllSides) {
  const Maze cell = Maze(MazeDraft({1, 1}, MazeDraft::Inside::closed)).with_goals(CellSet::all({1, 1}));
  std::set<int> rotations;
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    const Action action = test::wander(random_move_mouse, cell, seed).steps.front().action;
    EXPECT_EQ(action.movement, 0);
    rotations.insert(action.rotation);
  }
  EXPECT_EQ(rotations, (std::set{-90, 0, 90}));
}

TEST(RandomMove, GoesNoFartherThanTheRulesAllow) {
  const Maze maze = test::wandering_ground();
  for (const int stride : {1, 5}) {
    Rules rules;
    rules.stride = stride;
    int longest = 0;
    const auto mind = random_move_mouse.make(brief(maze, rules, 1), Settings(random_move_mouse.parameters));
    for (const StepRecord& step : run(maze, rules, *mind).steps) {
      EXPECT_FALSE(step.blocked);
      longest = std::max(longest, step.action.movement);
    }
    EXPECT_EQ(longest, stride);
  }
}

TEST(RandomMove, ResetsAfterTheGoalAtItsCoverage) {
  const Maze maze = test::wandering_ground();
  for (const char* coverage : {"0", "0.5", "1"}) {
    const RunRecord record = test::wander(random_move_mouse, maze, 1, {{"coverage", coverage}});
    EXPECT_EQ(record.outcome, Outcome::solved);
    test::expect_reset_at_coverage(maze, record, std::stod(coverage));
  }
}

TEST(RandomMove, RacesOnlyWhereItWasAndWhatLiesBetween) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    test::expect_speed_run_over_near_walls(test::wander(random_move_mouse, test::wandering_ground(seed), seed));
}

}  // namespace
}  // namespace labmouse
