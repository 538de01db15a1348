// Walks that the reports of others print, move by move: in the same world they lead to the same places.
#include <gtest/gtest.h>

#include "labmouse/contest/score.hpp"
#include "labmouse/contest/script.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/routes.hpp"
#include "tests/capstone_mazes.hpp"

namespace labmouse {
namespace {

/// A walk as it is printed: a rotation in degrees and a movement in cells for each step.
struct PrintedWalk {
  const char* name;
  int maze = 0;
  int moves = 0;
  std::vector<Action> actions;
};

void PrintTo(const PrintedWalk& walk, std::ostream* out) { *out << walk.name; }

/// A whole contest: the walk, the reset, and the walk once more.
Score contest_with(const Maze& maze, const std::vector<Action>& walk) {
  std::vector<Action> actions = walk;
  actions.push_back(Action::reset());
  actions.insert(actions.end(), walk.begin(), walk.end());
  Script mouse(maze.size(), actions);
  return score(run(maze, Rules(), mouse), Rules());
}

std::vector<Action> steps(std::initializer_list<std::pair<int, int>> list) {
  std::vector<Action> actions;
  for (const auto& [rotation, movement] : list) actions.push_back(Action::step(rotation, movement));
  return actions;
}

/// The moves that lead along a list of cells, each in a straight line from the one before.
std::vector<Action> moves_along(Pose pose, const std::vector<Cell>& cells) {
  std::vector<Action> actions;
  for (const Cell cell : cells) {
    const int dx = cell.x - pose.cell.x, dy = cell.y - pose.cell.y;
    const Heading direction = dy > 0   ? Heading::north
                              : dy < 0 ? Heading::south
                              : dx > 0 ? Heading::east
                                       : Heading::west;
    actions.push_back(move_in(pose.heading, direction, std::abs(dx) + std::abs(dy)));
    pose = after(pose, actions.back());
  }
  return actions;
}

class PrintedWalks : public testing::TestWithParam<PrintedWalk> {};

TEST_P(PrintedWalks, EndInTheGoalWithTheirLastMove) {
  const PrintedWalk& walk = GetParam();
  const auto maze = test::capstone_maze(walk.maze);
  if (!maze) GTEST_SKIP() << "the file of test maze " << walk.maze << " is not here";
  const Score result = contest_with(*maze, walk.actions);
  EXPECT_EQ(result.outcome, Outcome::finished);
  EXPECT_EQ(result.search_steps, walk.moves + 1);
  EXPECT_EQ(result.speed_steps, walk.moves);
}

INSTANTIATE_TEST_SUITE_P(
    VisitCounterReport, PrintedWalks,
    testing::Values(
        PrintedWalk{"Maze1Optimal", 1, 17,
                    steps({{0, 2},
                           {90, 1},
                           {90, 2},
                           {-90, 3},
                           {-90, 2},
                           {90, 2},
                           {90, 1},
                           {-90, 1},
                           {90, 1},
                           {-90, 1},
                           {0, 3},
                           {-90, 3},
                           {-90, 3},
                           {90, 2},
                           {-90, 1},
                           {90, 1},
                           {-90, 1}})},
        PrintedWalk{"Maze1NotOptimal", 1, 20, steps({{0, 2},  {0, 3},   {0, 3},   {0, 3},  {90, 1},  {90, 1}, {-90, 1},
                                                     {90, 2}, {-90, 1}, {-90, 3}, {90, 1}, {0, 3},   {90, 1}, {-90, 2},
                                                     {90, 2}, {90, 1},  {-90, 1}, {90, 1}, {-90, 1}, {90, 1}})},
        PrintedWalk{"Maze2Optimal", 2, 24,
                    steps({{0, 3},  {90, 2},  {90, 1}, {90, 1},  {-90, 2}, {-90, 1}, {0, 3},  {-90, 1},
                           {90, 1}, {-90, 2}, {90, 2}, {90, 2},  {-90, 2}, {-90, 1}, {90, 2}, {-90, 1},
                           {90, 1}, {-90, 3}, {0, 3},  {-90, 2}, {0, 3},   {-90, 1}, {90, 2}, {-90, 1}})},
        PrintedWalk{"Maze2NotOptimal", 2, 26,
                    steps({{0, 3},   {90, 2},  {90, 1},  {90, 1},  {-90, 2}, {-90, 1}, {0, 3},  {-90, 1}, {90, 1},
                           {-90, 2}, {90, 2},  {-90, 1}, {90, 2},  {90, 1},  {-90, 1}, {90, 1}, {-90, 1}, {-90, 1},
                           {90, 1},  {-90, 3}, {0, 3},   {-90, 2}, {0, 3},   {-90, 1}, {90, 2}, {-90, 1}})},
        PrintedWalk{"Maze3Optimal", 3, 26,
                    steps({{0, 3},   {90, 2}, {-90, 1}, {-90, 2}, {90, 2}, {0, 3},   {0, 3},  {0, 3},   {90, 1},
                           {0, 3},   {0, 3},  {90, 1},  {-90, 1}, {90, 1}, {-90, 1}, {90, 1}, {-90, 3}, {90, 1},
                           {-90, 2}, {90, 2}, {90, 3},  {-90, 2}, {90, 1}, {-90, 1}, {90, 2}, {90, 1}})},
        PrintedWalk{"Maze3NotOptimal", 3, 27,
                    steps({{0, 3},   {90, 2}, {90, 1},  {90, 1}, {-90, 2}, {-90, 1}, {-90, 1}, {90, 1}, {0, 3},
                           {-90, 1}, {90, 1}, {0, 3},   {90, 1}, {90, 3},  {-90, 1}, {-90, 2}, {0, 3},  {0, 3},
                           {-90, 2}, {0, 3},  {-90, 1}, {90, 2}, {-90, 2}, {-90, 1}, {90, 1},  {0, 3},  {90, 1}})}),
    [](const auto& walk) { return std::string(walk.param.name); });

INSTANTIATE_TEST_SUITE_P(FloodFillReport, PrintedWalks,
                         testing::Values(PrintedWalk{
                             "Maze1AsCells", 1, 20,
                             moves_along({{0, 0}, Heading::north},
                                         {{0, 3}, {0, 6}, {2, 6}, {2, 5}, {3, 5}, {3, 4},  {4, 4},
                                          {4, 7}, {4, 8}, {7, 8}, {7, 9}, {8, 9}, {8, 10}, {9, 10},
                                          {9, 8}, {8, 8}, {8, 7}, {7, 7}, {7, 6}, {5, 6}})}),
                         [](const auto& walk) { return std::string(walk.param.name); });

class TestMaze : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(TestMaze, HasItsShortestRun) {
  const auto [number, steps] = GetParam();
  const auto maze = test::capstone_maze(number);
  if (!maze) GTEST_SKIP() << "the file of test maze " << number << " is not here";
  EXPECT_EQ(shortest_in_strides(*maze).value().strides, steps);
}

INSTANTIATE_TEST_SUITE_P(OneToThree, TestMaze, testing::Values(std::pair{1, 17}, std::pair{2, 22}, std::pair{3, 25}));

}  // namespace
}  // namespace labmouse
