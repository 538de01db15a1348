#include <gtest/gtest.h>

#include "labmouse/mouse/distance.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/strategies/one_contest.hpp"

namespace labmouse {
namespace {

/// Moves from the nearest cells of a field's sources to the nearest cell outside of a set.
int nearest_outside(const DistanceField& field, const CellSet& cells) {
  int nearest = unreachable;
  for (int index = 0; index < field.size().area(); ++index)
    if (const Cell cell = field.size().cell_at(index); !cells.contains(cell))
      nearest = std::min(nearest, field.at(cell));
  return nearest;
}

TEST(Frontier, GoesToTheNearestCellThatItHasNeitherEnteredNorPassed) {
  for (const Maze& maze : test::loopy_mazes()) {
    CellSet entered;
    DistanceField field(maze.size(), strides());
    const auto check = [&](const StepRecord& step, const Knowledge& knowledge) {
      entered.insert(step.pose.cell);
      CellSet here, there;
      here.insert(step.pose.cell);
      field.fill(knowledge.open(), here);
      const int before = nearest_outside(field, entered);
      const Pose next = after(step.pose, step.action);
      there.insert(next.cell);
      field.fill(knowledge.open(), there);
      EXPECT_EQ(nearest_outside(field, entered), before - 1) << step.step;
      const int way = step.action.movement < 0 ? -1 : 1;
      for (int cells = 0; cells != step.action.movement; cells += way)
        entered.insert(neighbour(next.cell, next.heading, -cells));
    };
    test::follow_exploration(maze, test::contest(frontier_mouse, maze), check);
  }
}

TEST(Frontier, TakesTheFarthestInItsFirstDirectionOfSeveralThatAreEquallyNear) {
  const Maze maze = empty_generator.make({{12, 12}, 1, 0});
  const auto first_step = [&](std::string_view ties) {
    return test::contest(frontier_mouse, maze, {{"ties", ties}}).steps.front().action;
  };
  EXPECT_EQ(first_step("wsen"), Action::step(0, 1));
  EXPECT_EQ(first_step("nesw"), Action::step(0, 3));
  EXPECT_EQ(first_step("swen"), Action::step(90, 1));
  EXPECT_EQ(first_step("ralb"), Action::step(90, 3));
}

TEST(Frontier, ComesBackToAGoalThatItHasPassed) {
  const Maze maze = test::drawn(R"(
    o---o---o---o---o
    |         G   S |
    o---o---o---o---o
  )");
  const RunRecord record = test::contest(frontier_mouse, maze);
  EXPECT_EQ(record.outcome, Outcome::solved);
  EXPECT_EQ(record.steps[0].action, Action::step(-90, 3));
  EXPECT_EQ(record.steps[1].action, Action::step(0, -2));
}

}  // namespace
}  // namespace labmouse
