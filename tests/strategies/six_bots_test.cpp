// The deterministic mice of the third report in its mazes: the steps that they take, and how far their scores are from
// the ones that it prints.
#include <gtest/gtest.h>

#include <optional>
#include <utility>

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

std::optional<Maze> maze_of(int number) {
  return number == 0 ? empty_generator.make({{12, 12}, 1, 0}) : test::capstone_maze(number);
}

class SixBots : public testing::TestWithParam<Row> {};

TEST_P(SixBots, ScoreAsStated) {
  const Row& row = GetParam();
  const auto maze = maze_of(row.maze);
  if (!maze) GTEST_SKIP() << "the file of test maze " << row.maze << " is not here";
  const Score result = score(test::contest(*row.mouse, *maze), Rules());
  EXPECT_EQ(result.outcome, Outcome::solved);
  EXPECT_EQ(result.exploration_steps, row.exploration);
  EXPECT_EQ(result.speed_steps, row.speed);
  EXPECT_NEAR(result.value.value_or(0) - row.reported, row.difference, 0.001);
}

INSTANTIATE_TEST_SUITE_P(
    ThirdReport, SixBots,
    testing::Values(Row{&manhattan_mouse, 1, 391, 21, 35.4, -1.367}, Row{&manhattan_mouse, 2, 420, 27, 40.8, 0.2},
                    Row{&manhattan_mouse, 3, 116, 32, 33.9, 1.967}, Row{&manhattan_mouse, 0, 5, 4, 4.267, -0.1},
                    Row{&frontier_mouse, 1, 39, 18, 19.3, 0.0}, Row{&frontier_mouse, 2, 250, 22, 30.333, 0.0},
                    Row{&frontier_mouse, 3, 208, 25, 31.933, 0.0}, Row{&frontier_mouse, 0, 20, 4, 4.667, 0.0},
                    Row{&potential_mouse, 1, 150, 17, 21.933, 0.067}, Row{&potential_mouse, 2, 97, 27, 30.267, -0.033},
                    Row{&potential_mouse, 3, 116, 25, 28.9, -0.033}, Row{&potential_mouse, 0, 5, 4, 4.167, 0.0}),
    [](const auto& row) { return std::string(row.param.mouse->name) + "InMaze" + std::to_string(row.param.maze); });

TEST(FrontierBot, ScoresAsPrintedInEveryOrder) {
  for (const auto& [number, reported] : {std::pair{0, 4.667}, {1, 19.3}, {2, 30.333}, {3, 31.933}}) {
    const auto maze = maze_of(number);
    if (!maze) GTEST_SKIP() << "the file of test maze " << number << " is not here";
    for (const auto order : {"nesw", "enws", "swen", "wsne", "alrb", "lrab", "rbla", "blra"})
      EXPECT_NEAR(score(test::contest(frontier_mouse, *maze, {{"ties", order}}), Rules()).value.value_or(0), reported,
                  0.001)
          << order << " in " << number;
  }
}

}  // namespace
}  // namespace labmouse
