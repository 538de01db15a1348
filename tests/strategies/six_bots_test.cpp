// The deterministic mice of the third report in its mazes and in three more of its author's: each score that was
// printed, with its steps, and what the order of a hash table was worth.
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "labmouse/contest/score.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/strategies/one_contest.hpp"

namespace labmouse {
namespace {

struct Row {
  const BuiltinMouse* mouse;
  const char* maze;
  int search_run;
  int speed;
  double reported;
};

/// Test maze "1" to "3", "open" for the empty one of 12×12, or a file of the report's author.
std::optional<Maze> maze_of(const std::string& name) {
  if (name == "open") return empty_generator.make({{12, 12}, 1, 0});
  if (name.size() == 1) return test::capstone_maze(name.front() - '0');
  return test::maze_in_file(test::folder_of_mazes() / "report3" / (name + ".txt"));
}

class SixBots : public testing::TestWithParam<Row> {};

TEST_P(SixBots, ScoreAsPrinted) {
  const Row& row = GetParam();
  const auto maze = maze_of(row.maze);
  if (!maze) GTEST_SKIP() << "the file of maze " << row.maze << " is not here";
  const Score result = score(test::contest(*row.mouse, *maze), Rules());
  EXPECT_EQ(result.outcome, Outcome::finished);
  EXPECT_EQ(result.search_steps, row.search_run);
  EXPECT_EQ(result.speed_steps, row.speed);
  EXPECT_NEAR(result.value.value_or(0), row.reported, 0.0005);
}

INSTANTIATE_TEST_SUITE_P(
    ThirdReport, SixBots,
    testing::Values(Row{&frontier_mouse, "1", 39, 18, 19.3}, Row{&frontier_mouse, "2", 250, 22, 30.333},
                    Row{&frontier_mouse, "3", 208, 25, 31.933}, Row{&frontier_mouse, "open", 20, 4, 4.667},
                    Row{&frontier_mouse, "custom_maze_02", 33, 12, 13.1},
                    Row{&frontier_mouse, "custom_maze_03", 889, 19, 48.633}, Row{&manhattan_mouse, "1", 462, 20, 35.4},
                    Row{&manhattan_mouse, "2", 444, 26, 40.8}, Row{&manhattan_mouse, "3", 147, 29, 33.9},
                    Row{&manhattan_mouse, "open", 8, 4, 4.267}, Row{&manhattan_mouse, "custom_maze_02", 51, 12, 13.7},
                    Row{&potential_mouse, "1", 118, 18, 21.933}, Row{&potential_mouse, "2", 128, 26, 30.267},
                    Row{&potential_mouse, "3", 117, 25, 28.9}, Row{&potential_mouse, "open", 5, 4, 4.167},
                    Row{&potential_mouse, "custom_maze_02", 34, 9, 10.133},
                    Row{&potential_mouse, "custom_maze_03", 245, 19, 27.167}),
    [](const auto& row) { return std::string(row.param.mouse->name) + "_in_" + row.param.maze; });

TEST(ManhattanBot, FailsWhereItIsSaidTo) {
  const auto maze = maze_of("custom_maze_03");
  if (!maze) GTEST_SKIP() << "the file of maze custom_maze_03 is not here";
  EXPECT_EQ(test::contest(manhattan_mouse, *maze).outcome, Outcome::out_of_steps);
}

TEST(PotentialBot, RacesThroughCellsInWhichItNeverStood) {
  const auto maze = maze_of("3");
  if (!maze) GTEST_SKIP() << "the file of maze 3 is not here";
  CellSet stood, raced;
  for (const StepRecord& step : test::contest(potential_mouse, *maze).steps)
    (step.run == Run::speed ? raced : stood).insert(step.pose.cell);
  for (const Cell cell : {Cell{0, 15}, Cell{3, 15}}) {
    EXPECT_TRUE(raced.contains(cell));
    EXPECT_FALSE(stood.contains(cell));
  }
}

/// Another order, another walk: the scores are of one version's tables.
TEST(SixBots, DependOnTheTablesOfTheirLanguage) {
  const auto maze = maze_of("1");
  ASSERT_TRUE(maze);
  for (const auto order : {"rows", "python-2.7", "python-3.5"})
    EXPECT_NE(test::contest(potential_mouse, *maze, {{"order", order}}).steps.size(), 118U + 18U) << order;
}

}  // namespace
}  // namespace labmouse
