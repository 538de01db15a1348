#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>

#include "labmouse/mouse/connected_cells.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/strategies/one_contest.hpp"

namespace labmouse {
namespace {

/// The ground as the method describes it, from a record.
class Ground {
 public:
  explicit Ground(const Maze& maze) : maze_(maze), map_(maze.size(), 3, CellOrder::python_3_4) {}

  /// Where the mouse has to go; nothing where it can go nowhere.
  std::optional<Cell> next(const StepRecord& step) {
    const Cell here = step.pose.cell;
    map_.learn(step.pose, step.sighting);
    const auto cells = map_.of(here);
    if (step.sighting == Sighting{}) potentials_[here] = 2.0 * std::max(maze_.size().width, maze_.size().height);
    if (cells.size() > 1) potentials_[here] = 2.0 * potential(here);
    std::optional<Cell> lowest;
    for (const Cell cell : cells)
      if (!lowest || potential(cell) < potential(*lowest)) lowest = cell;
    return lowest;
  }

 private:
  double potential(Cell cell) const {
    const auto raised = potentials_.find(cell);
    if (raised != potentials_.end()) return raised->second;
    int columns = max_side, rows = max_side;
    maze_.goals().for_each([&](Cell goal) {
      columns = std::min(columns, std::abs(goal.x - cell.x));
      rows = std::min(rows, std::abs(goal.y - cell.y));
    });
    return columns + rows;
  }

  const Maze& maze_;
  ConnectedCells map_;
  std::map<Cell, double> potentials_;
};

TEST(Potential, GoesToTheFirstOfTheLowestCells) {
  for (const Maze& maze : test::loopy_mazes()) {
    Ground ground(maze);
    test::follow_search_run(maze, test::contest(potential_mouse, maze), [&](const StepRecord& step, const Knowledge&) {
      const auto next = ground.next(step);
      if (next)
        ASSERT_EQ(after(step.pose, step.action).cell, *next) << step.step;
      else
        ASSERT_EQ(step.action, Action::step(90, 0)) << step.step;
    });
  }
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
  EXPECT_EQ(test::contest(potential_mouse, maze).outcome, Outcome::finished);
}

TEST(Potential, GoesStraightToTheGoalWhereNothingIsInTheWay) {
  const RunRecord record = test::contest(potential_mouse, empty_generator.make({{12, 12}, 1, 0}));
  EXPECT_EQ(record.steps[4].action, Action::reset());
}

}  // namespace
}  // namespace labmouse
