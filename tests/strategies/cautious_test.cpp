#include <gtest/gtest.h>

#include <set>

#include "labmouse/mouse/known_moves.hpp"
#include "labmouse/mouse/visits.hpp"
#include "tests/strategies/one_contest.hpp"

namespace labmouse {
namespace {

/// Cells in which the mouse stood in the exploration.
int visited_cells(const RunRecord& record) {
  CellSet cells;
  for (const StepRecord& step : record.steps)
    if (step.run == Run::exploration) cells.insert(step.pose.cell);
  return cells.count();
}

TEST(Cautious, MovesByOneCell) {
  for (const Maze& maze : test::loopy_mazes())
    test::follow_exploration(maze, test::contest(cautious_mouse, maze), [](const StepRecord& step, const Knowledge&) {
      ASSERT_LE(std::abs(step.action.movement), 1);
    });
}

TEST(Cautious, TakesANeighbourThatItHasVisitedLeast) {
  for (const Maze& maze : test::loopy_mazes()) {
    Visits visits(maze.size());
    const auto check = [&](const StepRecord& step, const Knowledge& knowledge) {
      visits.add(step.pose.cell);
      const int chosen = visits.of(after(step.pose, step.action).cell);
      for (const Move& move : KnownMoves(knowledge.open(), step.pose.cell, 1))
        ASSERT_LE(chosen, visits.of(neighbour(step.pose.cell, move.direction))) << step.step;
    };
    test::follow_exploration(maze, test::contest(cautious_mouse, maze), check);
  }
}

TEST(Cautious, LeavesItToChanceWhereSeveralNeighboursAreEqual) {
  const Maze maze = empty_generator.make({{5, 5}, 1, 0});
  std::set<int> rotations;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    rotations.insert(test::contest(cautious_mouse, maze, {}, seed).steps.front().action.rotation);
  EXPECT_EQ(rotations, (std::set<int>{0, 90}));
}

TEST(Cautious, ResetsInTheGoalByDefault) {
  for (const Maze& maze : test::loopy_mazes())
    for (const StepRecord& step : test::contest(cautious_mouse, maze).steps)
      if (step.run == Run::exploration) {
        ASSERT_EQ(step.action.kind == Action::Kind::reset, maze.is_goal(step.pose.cell));
      }
}

TEST(Cautious, VisitsTheShareOfCellsAndStopsThere) {
  const Maze maze = prim_generator.make({{10, 10}, 5, 100});
  const RunRecord half = test::contest(cautious_mouse, maze, {{"explore_frac", "0.6"}}, 3);
  const RunRecord goal = test::contest(cautious_mouse, maze, {}, 3);
  ASSERT_LT(visited_cells(goal), 60);
  EXPECT_EQ(visited_cells(half), 60);
  EXPECT_EQ(half.outcome, Outcome::solved);
}

TEST(Cautious, VisitsEveryCellIfAskedTo) {
  Rules patient;
  patient.budget = 100'000;
  const Maze maze = prim_generator.make({{10, 10}, 5, 100});
  EXPECT_EQ(visited_cells(test::contest(cautious_mouse, maze, {{"explore_frac", "1"}}, 1, patient)), 100);
}

TEST(Cautious, NeedsTheGoalAlsoWhereItsShareIsReached) {
  const Maze maze = depth_first_generator.make({{10, 10}, 5, 0});
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const RunRecord record = test::contest(cautious_mouse, maze, {{"explore_frac", "0.05"}}, seed);
    bool entered = false;
    for (const StepRecord& step : record.steps) {
      entered = entered || maze.is_goal(step.pose.cell);
      if (step.action.kind == Action::Kind::reset) {
        ASSERT_TRUE(entered) << seed;
      }
    }
  }
}

}  // namespace
}  // namespace labmouse
