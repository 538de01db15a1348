#include <gtest/gtest.h>

#include "tests/strategies/wanderers.hpp"

namespace labmouse {
namespace {

TEST(DeadEnd, TurnsRightOnTheSpotInADeadEndAndGoesACellElsewhere) {
  int dead_ends = 0;
  const RunRecord record = test::wander(dead_end_mouse, depth_first_generator.make({{8, 8}, 1, 0}), 1);
  test::in_search_run(record, [&](const StepRecord& step) {
    if (step.action.kind == Action::Kind::reset) return;
    if (step.sighting != test::dead_end) {
      ASSERT_EQ(step.action.movement, 1);
      return;
    }
    ++dead_ends;
    EXPECT_EQ(step.action, Action::step(90, 0));
  });
  EXPECT_GT(dead_ends, 10);
}

TEST(DeadEnd, GoesToEveryFreeCellEquallyOften) {
  MazeDraft draft({3, 3}, MazeDraft::Inside::open);
  draft.close({1, 1}, Heading::east);
  const Maze maze = Maze(draft).with_start({1, 1}, Heading::north);
  int left = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    const Action first = test::wander(dead_end_mouse, maze, seed, {}, 1).steps.front().action;
    ASSERT_NE(first.rotation, 90);
    left += first.rotation == -90;
  }
  EXPECT_NEAR(left, 500, 80);
}

TEST(DeadEnd, MarksNothingInADeadEnd) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Maze maze = test::wandering_ground(seed);
    for (const char* coverage : {"0", "0.5", "0.8333"})
      test::expect_reset_at_coverage(maze, test::wander(dead_end_mouse, maze, seed, {{"coverage", coverage}}),
                                     std::stod(coverage));
  }
}

TEST(DeadEnd, RacesWhereItWalked) { test::expect_speed_runs_where_it_walked(dead_end_mouse); }

}  // namespace
}  // namespace labmouse
