// The deterministic mice of the third report in its mazes: the steps that they take, and how far their scores are from
// the ones that it prints.
#include <gtest/gtest.h>

#include "labmouse/contest/score.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/strategies/one_contest.hpp"

namespace labmouse {
namespace {

struct Row {
  const RosterEntry* mouse;
  int maze;  ///< 1 to 3; 0 is the empty one of 12×12
  int exploration;
  int speed;
  double reported;
  double difference;  ///< ours minus reported
};

class SixBots : public testing::TestWithParam<Row> {};

TEST_P(SixBots, ScoreAsStated) {
  const Row& row = GetParam();
  const auto maze = row.maze == 0 ? empty_generator.make({{12, 12}, 1, 0}) : test::capstone_maze(row.maze);
  if (!maze) GTEST_SKIP() << "the file of test maze " << row.maze << " is not here";
  const Score result = score(test::contest(*row.mouse, *maze), Rules());
  EXPECT_EQ(result.outcome, Outcome::solved);
  EXPECT_EQ(result.exploration_steps, row.exploration);
  EXPECT_EQ(result.speed_steps, row.speed);
  EXPECT_NEAR(result.value.value_or(0) - row.reported, row.difference, 0.001);
}

INSTANTIATE_TEST_SUITE_P(
    ThirdReport, SixBots,
    testing::Values(Row{&manhattan_mouse, 1, 437, 20, 35.4, -0.833}, Row{&manhattan_mouse, 2, 425, 27, 40.8, 0.367},
                    Row{&manhattan_mouse, 3, 142, 31, 33.9, 1.833}, Row{&manhattan_mouse, 0, 5, 4, 4.267, -0.1},
                    Row{&frontier_mouse, 1, 76, 17, 19.3, 0.233}, Row{&frontier_mouse, 2, 120, 26, 30.333, -0.333},
                    Row{&frontier_mouse, 3, 141, 28, 31.933, 0.767}, Row{&frontier_mouse, 0, 49, 4, 4.667, 0.967},
                    Row{&potential_mouse, 1, 150, 17, 21.933, 0.067}, Row{&potential_mouse, 2, 97, 27, 30.267, -0.033},
                    Row{&potential_mouse, 3, 116, 25, 28.9, -0.033}, Row{&potential_mouse, 0, 5, 4, 4.167, 0.0}),
    [](const auto& row) { return std::string(row.param.mouse->name) + "InMaze" + std::to_string(row.param.maze); });

}  // namespace
}  // namespace labmouse
