#include <gtest/gtest.h>

#include "tests/strategies/wanderers.hpp"

namespace labmouse {
namespace {

TEST(DeadEnd, TurnsRightOnTheSpotInADeadEnd) {
  int dead_ends = 0;
  for (const StepRecord& step : test::wander(dead_end_mouse, depth_first_generator.make({{8, 8}, 1, 0}), 1).steps) {
    if (step.run == Run::speed || step.sighting != Sighting{0, 0, 0}) continue;
    if (step.action.kind == Action::Kind::reset) continue;
    ++dead_ends;
    EXPECT_EQ(step.action, Action::step(90, 0));
  }
  EXPECT_GT(dead_ends, 10);
}

TEST(DeadEnd, LeavesAllElseToChance) {
  // Until the first dead end it does what random-move does with the same dice.
  const Maze maze = test::wandering_ground();
  const RunRecord turns = test::wander(dead_end_mouse, maze, 3), draws = test::wander(random_move_mouse, maze, 3);
  std::size_t same = 0;
  while (turns.steps[same].sighting != Sighting{0, 0, 0}) {
    ASSERT_EQ(turns.steps[same], draws.steps[same]);
    ++same;
  }
  EXPECT_GT(same, 3U);
}

TEST(DeadEnd, ResetsAfterTheGoalAtItsCoverage) {
  const Maze maze = test::wandering_ground();
  for (const char* coverage : {"0", "0.5", "1"}) {
    const RunRecord record = test::wander(dead_end_mouse, maze, 1, {{"coverage", coverage}});
    EXPECT_EQ(record.outcome, Outcome::solved);
    test::expect_reset_at_coverage(maze, record, std::stod(coverage));
  }
}

TEST(DeadEnd, RacesOnlyWhereItWasAndWhatLiesBetween) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    test::expect_speed_run_over_near_walls(test::wander(dead_end_mouse, test::wandering_ground(seed), seed));
}

}  // namespace
}  // namespace labmouse
