#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "labmouse/mouse/manhattan.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/strategies/one_contest.hpp"

namespace labmouse {
namespace {

constexpr int largest = 1 << 28;

/// The ground as the method describes it, from a record.
class Ground {
 public:
  explicit Ground(const Maze& maze) : maze_(maze) {
    bool found = false;
    maze.goals().for_each([&](Cell cell) {
      if (!found) goal_ = cell;
      found = true;
    });
  }

  void visit(const StepRecord& step, const Knowledge& knowledge) {
    const Cell here = step.pose.cell;
    if (step.sighting == Sighting{}) dead_ends_.insert(here);
    int free = 0;
    for (const Heading direction : all_headings) free += knowledge.open().contains(wall_at(here, direction)) ? 1 : 0;
    if (free > 1) ++raises_[maze_.size().index(here)];
  }
  int potential(Cell cell) {
    return dead_ends_.contains(cell) ? largest : manhattan(cell, goal_) * (1 + raises_[maze_.size().index(cell)]);
  }
  bool is_dead_end(Cell cell) const { return dead_ends_.contains(cell); }

 private:
  const Maze& maze_;
  Cell goal_;
  CellSet dead_ends_;
  std::map<int, int> raises_;
};

/// The cells that one move ahead, left or right leads to.
std::vector<Cell> in_sight(const StepRecord& step) {
  std::vector<Cell> cells;
  for (const int side : {-1, 0, 1})
    for (int away = 1; away <= std::min(3, step.sighting.towards(side)); ++away)
      cells.push_back(neighbour(step.pose.cell, turned(step.pose.heading, side), away));
  return cells;
}

TEST(Potential, GoesToTheLowestCellInSight) {
  for (const Maze& maze : test::loopy_mazes()) {
    Ground ground(maze);
    const auto check = [&](const StepRecord& step, const Knowledge& knowledge) {
      ground.visit(step, knowledge);
      const int chosen = ground.potential(after(step.pose, step.action).cell);
      for (const Cell cell : in_sight(step)) ASSERT_LE(chosen, ground.potential(cell)) << step.step;
    };
    test::follow_exploration(maze, test::contest(potential_mouse, maze), check);
  }
}

TEST(Potential, EntersADeadEndAgainOnlyWhereItSeesNothingElse) {
  for (const Maze& maze : test::loopy_mazes()) {
    Ground ground(maze);
    const auto check = [&](const StepRecord& step, const Knowledge& knowledge) {
      ground.visit(step, knowledge);
      if (step.action.movement == 0 || !ground.is_dead_end(after(step.pose, step.action).cell)) return;
      for (const Cell cell : in_sight(step)) EXPECT_TRUE(ground.is_dead_end(cell)) << step.step;
    };
    test::follow_exploration(maze, test::contest(potential_mouse, maze), check);
  }
}

TEST(Potential, NeverMovesBackAndTurnsOnTheSpotOnlyInDeadEnds) {
  for (const Maze& maze : test::loopy_mazes())
    test::follow_exploration(maze, test::contest(potential_mouse, maze), [](const StepRecord& step, const Knowledge&) {
      ASSERT_GE(step.action.movement, 0);
      ASSERT_EQ(step.action == Action::step(90, 0), step.sighting == Sighting{});
    });
}

TEST(Potential, LeavesAHollowAsItsGroundRises) {
  // The goal lies behind the wall at the end of the middle row: every way to it leads away from it first.
  const Maze maze = test::drawn(R"(
    o---o---o---o---o
    |               |
    o   o---o---o   o
    | S     | G     |
    o   o---o---o---o
    |               |
    o---o---o---o---o
  )");
  EXPECT_EQ(test::contest(potential_mouse, maze).outcome, Outcome::solved);
}

TEST(Potential, GoesStraightToTheGoalWhereNothingIsInTheWay) {
  const RunRecord record = test::contest(potential_mouse, empty_generator.make({{12, 12}, 1, 0}));
  EXPECT_EQ(record.steps[4].action, Action::reset());
}

}  // namespace
}  // namespace labmouse
