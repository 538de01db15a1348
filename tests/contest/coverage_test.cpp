#include "labmouse/contest/coverage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/contest/script.hpp"
#include "labmouse/contest/simulator.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse {
namespace {

using ::testing::ElementsAre;

/// Twelve cells, one of which nobody can reach: shares are of eleven.
const Maze& maze() {
  static const Maze drawing = test::drawn(R"(
    o---o---o---o---o
    |               |
    o   o---o---o   o
    |   |   |     G |
    o   o---o---o---o
    | S             |
    o---o---o---o---o
  )");
  return drawing;
}

RunRecord walk(std::vector<Action> actions, const Maze& where = maze(), int budget = 1000) {
  Rules rules;
  rules.budget = budget;
  Script script(where.size(), std::move(actions));
  return run(where, rules, script);
}

void expect_cells(const RunRecord& record, int discovered, int visited) {
  EXPECT_DOUBLE_EQ(coverage_of(record, maze()).discovered, discovered / 11.0);
  EXPECT_DOUBLE_EQ(coverage_of(record, maze()).visited, visited / 11.0);
}

const Action up = Action::step(0, 2);
const Action east = Action::step(90, 3);
const Action down = Action::step(90, 1);

TEST(Coverage, OfTheFirstReadingIsAllThatItShows) {
  // Stays at the start and looks: two cells ahead, three to the right.
  expect_cells(walk({Action::forfeit(ForfeitReason::finished)}), 6, 1);
}

TEST(Coverage, CountsCellsThatWereDrivenThrough) {
  // (0,1) is passed, (0,2) reached; from there the top row is seen.
  expect_cells(walk({up, Action::forfeit(ForfeitReason::finished)}), 9, 3);
}

TEST(Coverage, CountsOnlyWhatIsPassedBeforeAWall) {
  expect_cells(walk({Action::step(0, 3), Action::forfeit(ForfeitReason::finished)}), 9, 3);
}

TEST(Coverage, CountsBackwardsMoves) {
  expect_cells(
      walk({Action::step(90, 2), Action::step(0, -2), Action::step(-90, 1), Action::forfeit(ForfeitReason::finished)}),
      6, 4);
}

TEST(Coverage, TakesTheReadingAtTheEndOfTheExploration) {
  // From the goal the mouse looks west into (2,1): now all are seen, and seven driven through.
  const RunRecord record = walk({up, east, down, Action::reset()});
  ASSERT_EQ(record.steps[3].action, Action::reset());
  expect_cells(record, 11, 7);
}

TEST(Coverage, LeavesTheSpeedRunOut) {
  CellSet goal;
  goal.insert({0, 1});
  // The speed run passes the goal, sees the top row and drives into it.
  const RunRecord record = walk({Action::step(0, 1), Action::reset(), up, east}, maze().with_goals(goal));
  ASSERT_EQ(record.end.cell, (Cell{3, 2}));
  ASSERT_EQ(record.steps[3].run, Run::speed);
  expect_cells(record, 6, 2);
}

TEST(Coverage, AResetThatDoesNothingEndsNothing) {
  expect_cells(walk({Action::reset(), up, Action::forfeit(ForfeitReason::finished)}), 9, 3);
}

TEST(Coverage, WhereStepsRunOutTheLastCellIsVisitedButNoReadingTaken) {
  expect_cells(walk({up, east}, maze(), 2), 9, 6);
}

TEST(Coverage, DoesNotCountACellTwice) {
  expect_cells(
      walk({Action::step(90, 1), Action::step(0, -1), Action::step(0, 1), Action::forfeit(ForfeitReason::finished)}), 6,
      2);
}

TEST(Coverage, OfAnEmptyRecordIsNothing) { EXPECT_EQ(coverage_of(RunRecord(), maze()), Coverage()); }

TEST(Coverage, OfAMazeOfOneCellIsWhole) {
  const Maze cell = test::drawn("o---o\n| G |\no---o\n").with_start({0, 0}, Heading::north);
  EXPECT_EQ(coverage_of(walk({Action::step(0, 0), Action::reset()}, cell), cell), (Coverage{1.0, 1.0}));
}

TEST(Coverage, SurvivesARecordOfAnotherMaze) {
  RunRecord record = walk({up, east, down, Action::reset()});
  record.steps[1].pose.cell = {60, 60};
  record.steps[1].sighting = {64, 64, 64};
  const Maze cell = test::drawn("o---o\n| G |\no---o\n");
  EXPECT_EQ(coverage_of(record, cell).visited, 1.0);
  EXPECT_LE(coverage_of(record, maze()).discovered, 1.0);
}

TEST(ExploredWay, HasTheCellsInTheirOrder) {
  EXPECT_THAT(explored_way(walk({up, Action::step(0, -1), Action::reset()}), {4, 3}),
              ElementsAre(Cell{0, 0}, Cell{0, 1}, Cell{0, 2}, Cell{0, 1}));
}

}  // namespace
}  // namespace labmouse
