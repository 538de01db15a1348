#include "labmouse/lab/learn/maze_family.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "tests/slowness.hpp"

namespace labmouse {
namespace {

std::vector<Maze> mazes_of(MazeFamily family, Split split, std::uint64_t count) {
  family.split = split;
  std::vector<Maze> mazes;
  for (std::uint64_t number = 0; number < count; ++number) {
    const Maze maze = maze_of(family, number);
    if (std::find(mazes.begin(), mazes.end(), maze) == mazes.end()) mazes.push_back(maze);
  }
  return mazes;
}

// There are 192 perfect mazes of 3x3, so that the same ones are made again and again.
TEST(MazeFamily, SplitsShareNoMazeEvenWhereThereAreFew) {
  const MazeFamily family{&wilson_generator, {3, 3}, 0, Split::train, 0};
  const auto train = mazes_of(family, Split::train, 600);
  const auto validation = mazes_of(family, Split::validation, 300);
  const auto test = mazes_of(family, Split::test, 300);
  for (const auto* others : {&validation, &test})
    for (const Maze& maze : *others) EXPECT_EQ(std::find(train.begin(), train.end(), maze), train.end());
  for (const Maze& maze : test) EXPECT_EQ(std::find(validation.begin(), validation.end(), maze), validation.end());
  EXPECT_GT(train.size(), 100U);
  EXPECT_GT(validation.size(), 5U);
  EXPECT_GT(test.size(), 5U);
}

TEST(MazeFamily, SplitsGoByAllThatMakesMazesDiffer) {
  const Maze maze = wilson_generator.make({{8, 8}, 1, 0});
  std::set<Split> by_goal, by_start;
  for (int i = 0; i < 64; ++i) {
    by_goal.insert(split_of(maze.with_goals(CellSet::of({i % 8, i / 8}))));
    by_start.insert(split_of(maze.with_start({i % 8, i / 8}, Heading::north)));
  }
  EXPECT_EQ(by_goal.size(), all_splits.size());
  EXPECT_EQ(by_start.size(), all_splits.size());
}

TEST(MazeFamily, EqualNumbersGiveEqualMazes) {
  LABMOUSE_SKIP_SANITIZED();
  const MazeFamily family{&contest_generator, {16, 16}, 0, Split::test, 0};
  EXPECT_EQ(maze_of(family, 7), maze_of(family, 7));
  EXPECT_NE(maze_of(family, 7), maze_of(family, 8));
  EXPECT_EQ(split_of(maze_of(family, 7)), Split::test);
}

TEST(MazeFamily, RefusesASplitThatHasNoMazeOfTheSize) {
  int refused = 0;
  for (const Split split : all_splits)
    if (!refuses({&depth_first_generator, {1, 1}, 0, split, 0}).empty()) ++refused;
  EXPECT_EQ(refused, 2) << "there is one maze of 1x1, in one split";
  EXPECT_FALSE(refuses({&contest_generator, {7, 7}, 0, Split::train, 0}).empty());
}

}  // namespace
}  // namespace labmouse
