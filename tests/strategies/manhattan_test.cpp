#include "labmouse/mouse/manhattan.hpp"

#include <gtest/gtest.h>

#include "tests/drawn_maze.hpp"
#include "tests/strategies/one_contest.hpp"

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

/// Seen cells in which no step has ended and that look nearest to the goal.
CellSet targets(const Maze& maze, const DistanceField& from_here, const CellSet& visited) {
  CellSet best;
  int nearest = unreachable;
  for (int index = 0; index < maze.size().area(); ++index) {
    const Cell cell = maze.size().cell_at(index);
    if (!from_here.reaches(cell) || visited.contains(cell)) continue;
    const int distance = manhattan_to(maze.goals(), cell);
    if (distance < nearest) best = CellSet();
    nearest = std::min(nearest, distance);
    if (distance == nearest) best.insert(cell);
  }
  return best;
}

TEST(ManhattanMouse, TakesAShortestWayToTheSeenCellNearestToTheGoal) {
  for (const Maze& maze : test::loopy_mazes()) {
    CellSet visited;
    DistanceField from_here(maze.size(), strides()), from_there(maze.size(), strides());
    const auto check = [&](const StepRecord& step, const Knowledge& knowledge) {
      visited.insert(step.pose.cell);
      CellSet here, there;
      here.insert(step.pose.cell);
      there.insert(after(step.pose, step.action).cell);
      from_here.fill(knowledge.open(), here);
      from_there.fill(knowledge.open(), there);
      bool nearer = false;
      targets(maze, from_here, visited).for_each([&](Cell cell) {
        nearer = nearer || from_there.at(cell) == from_here.at(cell) - 1;
      });
      EXPECT_TRUE(nearer) << step.step;
    };
    test::follow_exploration(maze, test::contest(manhattan_mouse, maze), check);
  }
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
  EXPECT_EQ(record.outcome, Outcome::solved);
  EXPECT_EQ(record.steps.front().action, Action::step(90, 0));
}

}  // namespace
}  // namespace labmouse
