#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "labmouse/mouse/connected_cells.hpp"
#include "labmouse/mouse/manhattan.hpp"
#include "labmouse/mouse/visits.hpp"
#include "tests/strategies/one_contest.hpp"

namespace labmouse {
namespace {

/// Cells in which the mouse stood in the search run.
int visited_cells(const RunRecord& record) {
  CellSet cells;
  for (const StepRecord& step : record.steps)
    if (step.run == Run::search_run) cells.insert(step.pose.cell);
  return cells.count();
}

TEST(Cautious, GoesIntoANewNeighbourElseToTheLeastVisitedCellWithinAMove) {
  int fresh = 0, others = 0;
  for (const Maze& maze : test::loopy_mazes()) {
    Visits visits(maze.size());
    visits.add(maze.start());  // at birth
    ConnectedCells map(maze.size(), 3, CellOrder::python_3_4);
    test::follow_search_run(maze, test::contest(cautious_mouse, maze), [&](const StepRecord& step, const Knowledge&) {
      visits.add(step.pose.cell);
      map.learn(step.pose, step.sighting);
      const auto cells = map.of(step.pose.cell);
      const Cell to = after(step.pose, step.action).cell;
      const bool has_new = std::any_of(cells.begin(), cells.end(), [&](Cell cell) {
        return manhattan(cell, step.pose.cell) == 1 && visits.of(cell) == 0;
      });
      if (has_new) {
        ++fresh;
        ASSERT_EQ(std::abs(step.action.movement), 1) << step.step;
        ASSERT_EQ(visits.of(to), 0) << step.step;
      } else {
        ++others;
        const auto fewest =
            std::min_element(cells.begin(), cells.end(), [&](Cell a, Cell b) { return visits.of(a) < visits.of(b); });
        ASSERT_EQ(to, *fewest) << step.step;
      }
    });
  }
  EXPECT_GT(fresh, 100);
  EXPECT_GT(others, 20);
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
      if (step.run == Run::search_run) {
        ASSERT_EQ(step.action.kind == Action::Kind::reset, maze.is_goal(step.pose.cell));
      }
}

TEST(Cautious, VisitsTheShareOfCellsAndStopsThere) {
  const Maze maze = prim_generator.make({{10, 10}, 5, 100});
  const RunRecord most = test::contest(cautious_mouse, maze, {{"explore_frac", "0.8"}}, 4);
  const RunRecord goal = test::contest(cautious_mouse, maze, {}, 4);
  ASSERT_LT(visited_cells(goal), 80);
  EXPECT_EQ(visited_cells(most), 80);
  EXPECT_EQ(most.outcome, Outcome::finished);
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
