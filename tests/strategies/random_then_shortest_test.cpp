#include <gtest/gtest.h>

#include "labmouse/contest/score.hpp"
#include "labmouse/mouse/distance.hpp"
#include "tests/strategies/one_contest.hpp"

namespace labmouse {
namespace {

TEST(RandomThenShortest, ExploresAsTheRandomMouseDoes) {
  for (const Maze& maze : test::loopy_mazes()) {
    const RunRecord walk = test::contest(random_mouse, maze, {}, 7);
    const RunRecord record = test::contest(random_then_shortest_mouse, maze, {}, 7);
    for (std::size_t i = 0; i < record.steps.size() && record.steps[i].run == Run::search_run; ++i)
      ASSERT_EQ(record.steps[i], walk.steps[i]);
  }
}

TEST(RandomThenShortest, RacesByWhatItHasSeen) {
  int raced = 0;
  for (const Maze& maze : test::loopy_mazes()) {
    const RunRecord record = test::contest(random_then_shortest_mouse, maze, {}, 7);
    const Score result = score(record, Rules());
    if (result.outcome != Outcome::finished) continue;
    ++raced;
    Knowledge knowledge(maze.size());
    for (const StepRecord& step : record.steps)
      if (step.run == Run::search_run) {
        ASSERT_TRUE(knowledge.learn(step.pose, step.sighting));
      }
    DistanceField known(maze.size(), strides());
    known.fill(knowledge.open(), maze.goals());
    EXPECT_LE(result.speed_steps, known.at(maze.start()));
  }
  EXPECT_GT(raced, 0);
}

TEST(RandomThenShortest, GoesNoFartherThanItsStride) {
  for (const Maze& maze : test::loopy_mazes())
    test::follow_search_run(
        maze, test::contest(random_then_shortest_mouse, maze, {{"stride", "1"}}),
        [](const StepRecord& step, const Knowledge&) { ASSERT_LE(std::abs(step.action.movement), 1); });
}

}  // namespace
}  // namespace labmouse
