#include <gtest/gtest.h>

#include "tests/drawn_maze.hpp"
#include "tests/strategies/seekers.hpp"

namespace labmouse {
namespace {

TEST(Frontier, GoesToTheNearestCellThatItHasNotVisited) {
  for (const Maze& maze : test::loopy_mazes())
    test::expect_goes_to_the_cheapest(frontier_mouse, maze,
                                      [](const SearchTree& routes, Cell cell) { return routes.distance(cell); });
}

TEST(Frontier, MakesOnlyMovesThatItHasSeenAsAWhole) {
  for (const Maze& maze : test::loopy_mazes()) test::expect_makes_only_moves_seen_as_a_whole(frontier_mouse, maze);
}

TEST(Frontier, ComesBackToAGoalThatItHasPassed) {
  const Maze maze = test::drawn(R"(
    o---o---o---o---o
    | S       G     |
    o---o---o---o---o
  )");
  const RunRecord record = test::contest(frontier_mouse, maze);
  EXPECT_EQ(record.outcome, Outcome::finished);
  EXPECT_EQ(record.steps[0].action, Action::step(90, 3));
  EXPECT_EQ(record.steps[1].action, Action::step(0, -1));
}

}  // namespace
}  // namespace labmouse
