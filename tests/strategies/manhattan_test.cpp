#include "labmouse/mouse/manhattan.hpp"

#include <gtest/gtest.h>

#include "tests/drawn_maze.hpp"
#include "tests/strategies/seekers.hpp"

namespace labmouse {
namespace {

TEST(ManhattanDistance, CountsColumnsAndRows) {
  EXPECT_EQ(manhattan({1, 5}, {4, 3}), 5);
  EXPECT_EQ(manhattan({4, 3}, {1, 5}), 5);
  EXPECT_EQ(manhattan({2, 2}, {2, 2}), 0);
}

TEST(ManhattanDistance, LooksAtTheNearestCellOfASet) {
  CellSet cells;
  EXPECT_EQ(manhattan_to(cells, {0, 0}), unreachable);
  cells.insert({5, 5});
  cells.insert({1, 4});
  EXPECT_EQ(manhattan_to(cells, {0, 0}), 5);
}

TEST(ManhattanMouse, GoesToTheUnvisitedCellThatLooksNearestToTheGoal) {
  for (const Maze& maze : test::loopy_mazes())
    test::expect_goes_to_the_cheapest(manhattan_mouse, maze, [&](const SearchTree&, Cell cell) {
      // To the corner of the goal, in half cells.
      int x = max_side, y = max_side;
      maze.goals().for_each([&](Cell goal) {
        x = std::min<int>(x, goal.x);
        y = std::min<int>(y, goal.y);
      });
      return std::abs(2 * (cell.x - x) + 1) + std::abs(2 * (cell.y - y) + 1);
    });
}

TEST(ManhattanMouse, MakesOnlyMovesThatItHasSeenAsAWhole) {
  for (const Maze& maze : test::loopy_mazes()) test::expect_makes_only_moves_seen_as_a_whole(manhattan_mouse, maze);
}

TEST(ManhattanMouse, LooksBehindWhereTheOnlyWayBeginsThere) {
  const Maze maze = test::drawn(R"(
    o---o---o
    | S |   |
    o   o   o
    |     G |
    o---o---o
  )");
  const RunRecord record = test::contest(manhattan_mouse, maze);
  EXPECT_EQ(record.outcome, Outcome::finished);
  EXPECT_EQ(record.steps.front().action, Action::step(90, 0));
}

}  // namespace
}  // namespace labmouse
