#include <gtest/gtest.h>

#include "labmouse/contest/coverage.hpp"
#include "labmouse/contest/script.hpp"
#include "labmouse/contest/simulator.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse {
namespace {

/// A fork, a hall behind it, and a cell that nobody can reach.
Maze fork() {
  return test::drawn(R"(
      o---o---o---o---o
      |       |   |   |
      o   o---o   o---o
      |             G |
      o   o---o   o   o
      | S |           |
      o---o---o---o---o
  )");
}

CellSet cells(std::initializer_list<Cell> list) {
  CellSet set;
  for (const Cell cell : list) set.insert(cell);
  return set;
}

ExploredCells explored(std::vector<Action> actions) {
  Script script({4, 3}, std::move(actions));
  return explored_cells(run(fork(), Rules(), script), fork());
}

TEST(ExploredCells, StandingStillDiscoversTheCorridorAhead) {
  const ExploredCells found = explored({});
  EXPECT_EQ(found.visited, cells({{0, 0}}));
  EXPECT_EQ(found.discovered, cells({{0, 0}, {0, 1}, {0, 2}}));
  EXPECT_EQ(found.reachable.count(), 11);
}

TEST(ExploredCells, VisitsWhatItCrossesForwardAndBack) {
  const ExploredCells forward = explored({Action::step(0, 2)});
  EXPECT_EQ(forward.visited, cells({{0, 0}, {0, 1}, {0, 2}}));
  EXPECT_EQ(forward.discovered, cells({{0, 0}, {0, 1}, {0, 2}, {1, 2}}));
  const ExploredCells back = explored({Action::step(0, 1), Action::step(90, 3), Action::step(0, -2)});
  EXPECT_EQ(back.visited, cells({{0, 0}, {0, 1}, {1, 1}, {2, 1}, {3, 1}}));
  EXPECT_EQ(back.discovered, cells({{0, 0}, {0, 1}, {0, 2}, {1, 1}, {2, 1}, {3, 1}, {3, 0}}));
}

TEST(ExploredCells, AWallEndsAVisit) { EXPECT_EQ(explored({Action::step(90, 3)}).visited, cells({{0, 0}})); }

TEST(ExploredCells, TheSpeedRunAddsNothing) {
  // To the goal and back to the start; then the speed run strays through the cells in the south.
  const std::vector<Action> search_run = {Action::step(0, 1), Action::step(90, 3), Action::reset()};
  std::vector<Action> both = search_run;
  for (const Action& action : {Action::step(0, 1), Action::step(90, 2), Action::step(90, 1)}) both.push_back(action);
  EXPECT_EQ(explored(both), explored(search_run));
}

TEST(ExploredCells, RecordsThatLeaveTheMazeDoNoHarm) {
  RunRecord record;
  record.steps = {{Run::search_run, 1, {{3, 1}, Heading::east}, {9, 9, 9}, Action::step(0, 3), false}};
  record.end = {{60, 1}, Heading::east};
  EXPECT_EQ(explored_cells(record, fork()).visited, cells({{3, 1}}));
}

}  // namespace
}  // namespace labmouse
