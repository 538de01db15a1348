// What the second report prints of its mouse, and what it leaves to be seen.
#include <gtest/gtest.h>

#include <cmath>

#include "labmouse/contest/score.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/routes.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse {
namespace {

using Values = std::vector<std::pair<std::string_view, std::string_view>>;

RunRecord run_with(const Maze& maze, const Values& values = {}) {
  Settings settings(two_way_mouse.parameters);
  for (const auto& [name, value] : values) settings.set(name, value);
  return run(maze, {}, *two_way_mouse.make(brief(maze, {}, 1), settings));
}

std::int64_t counted(const RunRecord& record, std::string_view name) {
  for (const Count& count : record.counts)
    if (count.name == name) return count.value;
  return -1;
}

/// A stage of the mouse's making, and what it came to in a test maze.
struct Stage {
  const char* name;
  int maze = 0;
  Values values;
  int search_run = 0;
  int speed = 0;
  /// The score in tenths, as it is printed.
  long printed = 0;
};

void PrintTo(const Stage& stage, std::ostream* out) { *out << stage.name; }

class Stages : public testing::TestWithParam<Stage> {};

TEST_P(Stages, ScoreAsPrinted) {
  const Stage& stage = GetParam();
  const auto maze = test::capstone_maze(stage.maze);
  if (!maze) GTEST_SKIP() << "the file of test maze " << stage.maze << " is not here";
  const Score result = score(run_with(*maze, stage.values), Rules());
  ASSERT_EQ(result.outcome, Outcome::finished);
  EXPECT_EQ(result.search_steps, stage.search_run);
  EXPECT_EQ(result.speed_steps, stage.speed);
  EXPECT_EQ(std::lround(10 * *result.value), stage.printed);
}

const Values unbiased = {{"bias", "1"}, {"join_legs", "no"}, {"merge_strides", "no"}};
const Values biased = {{"join_legs", "no"}, {"merge_strides", "no"}};
const Values joined = {{"merge_strides", "no"}};

INSTANTIATE_TEST_SUITE_P(
    Report, Stages,
    testing::Values(Stage{"Unbiased1", 1, unbiased, 165, 32, 375}, Stage{"Unbiased2", 2, unbiased, 341, 49, 604},
                    Stage{"Unbiased3", 3, unbiased, 329, 57, 680}, Stage{"Biased1", 1, biased, 117, 32, 359},
                    Stage{"Biased2", 2, biased, 295, 49, 588}, Stage{"Biased3", 3, biased, 213, 51, 581},
                    Stage{"Joined1", 1, joined, 117, 30, 339}, Stage{"Joined2", 2, joined, 295, 49, 588},
                    Stage{"Joined3", 3, joined, 213, 51, 581}, Stage{"Final1", 1, {}, 117, 17, 209},
                    Stage{"Final2", 2, {}, 295, 33, 428}, Stage{"Final3", 3, {}, 213, 30, 371}),
    [](const auto& stage) { return std::string(stage.param.name); });

TEST(TwoWay, SeesAsMuchOfTheFirstMazeAsPrinted) {
  const RunRecord record = run_with(*test::capstone_maze(1));
  EXPECT_EQ(counted(record, "cells discovered on the way there"), 83);  // 57.6 % of 144
  EXPECT_EQ(counted(record, "cells visited on the way there"), 66);     // 45.8 %
  EXPECT_EQ(counted(record, "cells discovered on the way back"), 11);   // 7.6 %
  EXPECT_EQ(counted(record, "cells visited on the way back"), 34);      // 23.6 %
  // The goal is entered by step 80, so step 81 is the first that knows of it.
  EXPECT_EQ(record.steps[80].pose.cell, (Cell{6, 6}));
}

/// Test maze 1 with an open corridor along its northern border and two walls more.
Maze changed_maze() {
  const Maze maze = *test::capstone_maze(1);
  MazeDraft draft(maze.size(), MazeDraft::Inside::closed);
  maze.open_walls().for_each([&](Wall wall) { draft.open(wall.cell, wall.side); });
  for (int x = 0; x + 1 < maze.size().width; ++x) draft.open({x, maze.size().height - 1}, Heading::east);
  draft.close({7, 0}, Heading::north);
  draft.close({9, 8}, Heading::north);
  return Maze(draft);
}

TEST(TwoWay, MissesTheStraightWayInTheChangedMaze) {
  const RunRecord record = run_with(changed_maze());
  const auto discovered = counted(record, "cells discovered on the way there");
  EXPECT_EQ(discovered + counted(record, "cells discovered on the way back"), 142);  // 98.6 % of 144
  EXPECT_EQ(score(record, Rules()).speed_steps, 24);
  EXPECT_EQ(shortest_in_strides(changed_maze()).value().strides, 14);
}

TEST(TwoWay, ForgetsNoDeadEndOnTheWayBack) {
  // The pocket at (1,1) is nearer to the goal, and on the way back to the start, than the way on.
  const Maze maze = test::drawn(R"(
    o---o---o---o
    |       |   |
    o   o   o---o
    |   |       |
    o   o   o   o
    |   |   |   |
    o   o---o   o
    | S | G     |
    o---o---o---o
  )");
  int entered = 0;
  for (const StepRecord& step : run_with(maze).steps) entered += step.pose.cell == Cell{1, 1} ? 1 : 0;
  EXPECT_EQ(entered, 1);
}

TEST(TwoWay, TakesItsFirstStrideOneCellShorter) {
  const Maze maze = test::drawn(R"(
    o---o---o---o---o---o---o---o
    | S                       G |
    o---o---o---o---o---o---o---o
  )")
                        .with_start({0, 0}, Heading::east);
  const RunRecord record = run_with(maze);
  std::vector<int> strides;
  for (const StepRecord& step : record.steps)
    if (step.run == Run::speed) strides.push_back(step.action.movement);
  EXPECT_EQ(strides, (std::vector<int>{2, 3, 1}));
}

}  // namespace
}  // namespace labmouse
