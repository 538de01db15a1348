#include "labmouse/lab/bounds/bounds.hpp"

#include <gtest/gtest.h>

#include "labmouse/chance/rng.hpp"
#include "labmouse/contest/score.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/maze/routes.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/lab/races/race_fixture.hpp"

namespace labmouse {
namespace {

class BoundOfTestMaze : public testing::TestWithParam<std::tuple<int, int, double>> {};

TEST_P(BoundOfTestMaze, IsWhatThePerfectMouseScores) {
  const auto [number, steps, bound] = GetParam();
  const auto maze = test::capstone_maze(number);
  if (!maze) GTEST_SKIP() << "the file of test maze " << number << " is not here";
  EXPECT_EQ(bound_of(*maze, Rules()).optimum.value(), steps);
  EXPECT_NEAR(bound_of(*maze, Rules()).score.value(), bound, 0.0005);
}

INSTANTIATE_TEST_SUITE_P(OneToThree, BoundOfTestMaze,
                         testing::Values(std::tuple{1, 17, 17.600}, std::tuple{2, 22, 22.767},
                                         std::tuple{3, 25, 25.867}));

TEST(Bound, CountsTheShortestRunTwiceAndTheReset) {
  const Bound bound = bound_of(test::corridor().maze, Rules());
  EXPECT_EQ(bound.optimum, 3);  // three cells east, one south, three west
  EXPECT_DOUBLE_EQ(bound.score.value(), 3 + 4 / 30.0);
}

TEST(Bound, OfAMazeWithoutARouteIsNothing) {
  const Bound bound = bound_of(test::without_route().maze, Rules());
  EXPECT_EQ(bound.optimum, std::nullopt);
  EXPECT_EQ(bound.score, std::nullopt);
  EXPECT_TRUE(shortest_run(test::without_route().maze, Rules()).empty());
}

TEST(Bound, WhereTheStartIsAGoalOneStepHasToEndThere) {
  const Maze maze(MazeDraft({1, 1}, MazeDraft::Inside::closed));
  EXPECT_EQ(bound_of(maze, Rules()).optimum, 1);
  EXPECT_DOUBLE_EQ(bound_of(maze, Rules()).score.value(), 1 + 2 / 30.0);
}

TEST(Bound, DependsOnTheRules) {
  Rules rules;
  rules.stride = 1;
  rules.search_factor = 4;
  EXPECT_EQ(bound_of(test::corridor().maze, rules).optimum, 7);
  EXPECT_DOUBLE_EQ(bound_of(test::corridor().maze, rules).score.value(), 9.0);
}

TEST(Oracle, ScoresTheBoundInEveryMaze) {
  Rng rng(8);
  for (int i = 0; i < 100; ++i) {
    const Size size{1 + rng.below(24), 1 + rng.below(24)};
    const Maze maze =
        prim_generator.make({size, rng.bits(), rng.below(500)})
            .with_start(size.cell_at(rng.below(size.area())), all_headings[static_cast<std::size_t>(rng.below(4))]);
    const Score result = score(run(maze, Rules(), *make_oracle(maze, Rules())), Rules());
    ASSERT_EQ(result.value, bound_of(maze, Rules()).score);
    ASSERT_EQ(result.speed_steps, shortest_in_strides(maze).value().strides);
  }
}

TEST(Oracle, GivesUpWhereThereIsNoRoute) {
  const Maze maze = test::without_route().maze;
  EXPECT_NE(run(maze, Rules(), *make_oracle(maze, Rules())).outcome, Outcome::finished);
}

}  // namespace
}  // namespace labmouse
