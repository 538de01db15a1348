// flood-block and flood-explore against what the first report prints, and what they share.
#include "labmouse/strategies/cell_flood.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "labmouse/contest/score.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/routes.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/strategies/contract_mazes.hpp"

namespace labmouse {
namespace {

using test::capstone_maze;
using test::drawn;
using testing::ElementsAre;

RunRecord run_of(const BuiltinMouse& mouse, const Maze& maze, const Rules& rules = {}, std::string_view ties = "") {
  Settings settings(mouse.parameters);
  if (!ties.empty()) settings.set("ties", ties);
  return run(maze, rules, *mouse.make(brief(maze, rules, 1), settings));
}

std::vector<StepRecord> steps_of(const RunRecord& record, Run run) {
  std::vector<StepRecord> steps;
  std::copy_if(record.steps.begin(), record.steps.end(), std::back_inserter(steps),
               [&](const StepRecord& step) { return step.run == run; });
  return steps;
}

CellSet visited_in(const RunRecord& record) {
  CellSet cells;
  for (const StepRecord& step : steps_of(record, Run::search_run)) cells.insert(step.pose.cell);
  return cells;
}

/// Distances to a cell over the given passages, row by row from the north; -1 where there is no way.
std::vector<std::vector<int>> distances(Size size, const WallSet& passages, Cell goal) {
  CellSet goals;
  goals.insert(goal);
  DistanceField field(size, strides(1));
  field.fill(passages, goals);
  std::vector<std::vector<int>> rows;
  for (int y = size.height - 1; y >= 0; --y) {
    auto& row = rows.emplace_back();
    for (int x = 0; x < size.width; ++x) row.push_back(field.reaches({x, y}) ? field.at({x, y}) : -1);
  }
  return rows;
}

struct Reported {
  const BuiltinMouse* mouse;
  int maze, search_steps, speed_steps;
};

class ReportOne : public testing::TestWithParam<Reported> {};

TEST_P(ReportOne, IsReproducedExactly) {
  const auto maze = capstone_maze(GetParam().maze);
  if (!maze) GTEST_SKIP() << "test maze " << GetParam().maze << " is not here";
  const Score result = score(run_of(*GetParam().mouse, *maze), Rules());
  EXPECT_EQ(result.outcome, Outcome::finished);
  EXPECT_EQ(result.search_steps, GetParam().search_steps);
  EXPECT_EQ(result.speed_steps, GetParam().speed_steps);
}

// The report prints the scores: 25.4, 48 and 40.767; 33.733, 43.367 and 52.4.
INSTANTIATE_TEST_SUITE_P(
    Scores, ReportOne,
    testing::Values(Reported{&flood_block_mouse, 1, 42, 24}, Reported{&flood_block_mouse, 2, 90, 45},
                    Reported{&flood_block_mouse, 3, 83, 38}, Reported{&flood_explore_mouse, 1, 412, 20},
                    Reported{&flood_explore_mouse, 2, 551, 25}, Reported{&flood_explore_mouse, 3, 822, 25}),
    [](const auto& row) {
      return std::string(row.param.mouse == &flood_block_mouse ? "flood_block" : "flood_explore") + "_in_maze_" +
             std::to_string(row.param.maze);
    });

TEST(FloodBlock, ReproducesTheReportWithOneTieOrderOnly) {
  const auto two = capstone_maze(2), three = capstone_maze(3);
  if (!two || !three) GTEST_SKIP() << "test mazes 2 and 3 are not here";
  std::vector<std::string> orders;
  for (std::size_t at = 0; at < TieOrder::all.size(); at += 5) {
    const std::string ties(TieOrder::all.substr(at, 4));
    const auto scores = [&](const Maze& maze, double reported) {
      return std::abs(score(run_of(flood_block_mouse, maze, {}, ties), Rules()).value.value_or(0) - reported) < 0.001;
    };
    if (scores(*capstone_maze(1), 25.4) && scores(*two, 48) && scores(*three, 40.767)) orders.push_back(ties);
  }
  EXPECT_THAT(orders, ElementsAre("wsen"));
}

TEST(CellFlood, KnowsAfterTheFirstReadingWhatTheReportPrints) {
  // Maze 1: a corridor of eleven cells ahead of the start, walls on both sides of it.
  Knowledge knowledge({12, 12});
  ASSERT_TRUE(knowledge.learn({{0, 0}, Heading::north}, {0, 11, 0}));
  EXPECT_EQ(knowledge.state(wall_at({0, 0}, Heading::east)), WallState::closed);
  const auto rows = distances({12, 12}, knowledge.possible(), {5, 6});
  // The report's first index is the column: its first line is the westernmost column, from the south.
  const auto column = [&](unsigned x) {
    std::vector<int> cells;
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) cells.push_back((*row)[x]);
    return cells;
  };
  EXPECT_THAT(column(0), ElementsAre(11, 10, 9, 8, 7, 6, 5, 6, 7, 8, 9, 10));
  EXPECT_THAT(column(1), ElementsAre(10, 9, 8, 7, 6, 5, 4, 5, 6, 7, 8, 9));
  EXPECT_THAT(column(5), ElementsAre(6, 5, 4, 3, 2, 1, 0, 1, 2, 3, 4, 5));
  EXPECT_THAT(column(11), ElementsAre(12, 11, 10, 9, 8, 7, 6, 7, 8, 9, 10, 11));
}

/// The report's small example, drawn after its distances.
constexpr const char* example = R"(
  o---o---o---o---o
  |               |
  o   o   o   o   o
  |   |           |
  o   o---o   o   o
  |       | G     |
  o   o---o   o   o
  | S |           |
  o---o---o---o---o
)";

TEST(CellFlood, FindsTheDistancesOfTheReportOnItsWholeExample) {
  EXPECT_THAT(
      distances({4, 4}, drawn(example).open_walls(), {2, 1}),
      ElementsAre(ElementsAre(4, 3, 2, 3), ElementsAre(5, 2, 1, 2), ElementsAre(6, 7, 0, 1), ElementsAre(7, 2, 1, 2)));
}

TEST(CellFlood, FindsTheDistancesOfTheReportAmongTheCellsThatItWalked) {
  CellSet walked;
  for (const Cell cell :
       {Cell{0, 0}, Cell{0, 1}, Cell{0, 2}, Cell{0, 3}, Cell{1, 3}, Cell{2, 3}, Cell{2, 2}, Cell{2, 1}})
    walked.insert(cell);
  EXPECT_THAT(distances({4, 4}, passages_among(walked, drawn(example).open_walls()), {2, 1}),
              ElementsAre(ElementsAre(4, 3, 2, -1), ElementsAre(5, -1, 1, -1), ElementsAre(6, -1, 0, -1),
                          ElementsAre(7, -1, -1, -1)));
}

class BothFloods : public testing::TestWithParam<const BuiltinMouse*> {};

INSTANTIATE_TEST_SUITE_P(BuiltinMice, BothFloods, testing::Values(&flood_block_mouse, &flood_explore_mouse),
                         [](const auto& mouse) {
                           return mouse.param == &flood_block_mouse ? "flood_block" : "flood_explore";
                         });

TEST_P(BothFloods, ExploreOneCellAStepAndTurnInsteadOfGoingBack) {
  const auto steps = steps_of(run_of(*GetParam(), *capstone_maze(1)), Run::search_run);
  int turns = 0;
  for (const StepRecord& step : steps) {
    if (step.action.kind == Action::Kind::reset) continue;
    if (step.action.movement == 0) {
      ++turns;
      EXPECT_EQ(step.action.rotation, 90);
    } else {
      EXPECT_EQ(step.action.movement, 1);
    }
  }
  EXPECT_GT(turns, 0);
}

TEST_P(BothFloods, TurnWhereTheOnlyWayBeginsBehind) {
  const RunRecord record = run_of(*GetParam(), drawn(R"(
    o---o---o
    | S | G |
    o   o   o
    |       |
    o---o---o
  )"));
  EXPECT_EQ(record.steps[0].action, Action::step(90, 0));
  EXPECT_EQ(record.steps[1].action, Action::step(90, 1));
  EXPECT_EQ(record.outcome, Outcome::finished);
}

TEST_P(BothFloods, StayForAStepWhereTheyStartInTheGoal) {
  const Maze maze = drawn(R"(
    o---o---o
    |       |
    o   o   o
    | G |   |
    o---o---o
  )")
                        .with_start({0, 0}, Heading::north);
  const RunRecord record = run_of(*GetParam(), maze);
  EXPECT_EQ(record.steps.front().action, Action::step(0, 0));
  EXPECT_EQ(record.steps.back().action, Action::step(0, 0));
  EXPECT_EQ(score(record, Rules()).speed_steps, 1);
}

TEST_P(BothFloods, PassThroughTheOtherCellsOfTheGoal) {
  // The mouse floods to (1,2), the north-western cell of the goal; (2,1) is on the way.
  const Maze maze = drawn(R"(
    o---o---o---o---o
    |               |
    o   o   o   o   o
    |     G   G     |
    o   o   o   o   o
    |     G   G     |
    o---o---o   o   o
    | S             |
    o---o---o---o---o
  )");
  const CellSet visited = visited_in(run_of(*GetParam(), maze));
  EXPECT_TRUE(visited.contains({2, 1}));
  EXPECT_TRUE(visited.contains({1, 2}));
}

TEST_P(BothFloods, TakeTheNextGoalCellWhereOneIsClosedOff) {
  const Maze maze = drawn(R"(
    o---o---o---o
    | G |     G |
    o---o   o   o
    |           |
    o   o   o   o
    | S         |
    o---o---o---o
  )");
  const RunRecord record = run_of(*GetParam(), maze);
  EXPECT_TRUE(visited_in(record).contains({2, 2}));
  // The one then looks for the closed cell for ever.
  EXPECT_EQ(record.outcome, GetParam() == &flood_explore_mouse ? Outcome::never_reset : Outcome::finished);
}

TEST_P(BothFloods, RaceForwardsOnceTheyHaveLeftTheStart) {
  for (const test::ContractMaze& maze : test::contract_mazes())
    for (const StepRecord& step : steps_of(run_of(*GetParam(), maze.maze), Run::speed))
      ASSERT_TRUE(step.action.movement > 0 || step.pose.cell == maze.maze.start())
          << maze.name << " step " << step.step;
}

TEST_P(BothFloods, SolveEveryMazeWithARouteAndGiveUpInTheOthers) {
  Rules patient;
  patient.budget = 100'000;
  for (const test::ContractMaze& maze : test::contract_mazes()) {
    const bool has_route = shortest_in_cells(maze.maze).has_value();
    const bool looks_for_ever =
        GetParam() == &flood_explore_mouse && reachable_cells(maze.maze) != CellSet::all(maze.maze.size());
    EXPECT_EQ(run_of(*GetParam(), maze.maze, patient).outcome, !has_route       ? Outcome::forfeit
                                                               : looks_for_ever ? Outcome::never_reset
                                                                                : Outcome::finished)
        << maze.name;
  }
}

TEST(FloodBlock, RacesThroughVisitedCellsOnly) {
  for (const test::ContractMaze& maze : test::contract_mazes()) {
    const RunRecord record = run_of(flood_block_mouse, maze.maze);
    const CellSet visited = visited_in(record);
    for (const StepRecord& step : steps_of(record, Run::speed)) {
      Pose pose = step.pose;
      pose.heading = rotated(pose.heading, step.action.rotation);
      for (int cells = 0; cells <= std::abs(step.action.movement); ++cells) {
        EXPECT_TRUE(visited.contains(neighbour(pose.cell, pose.heading, step.action.movement < 0 ? -cells : cells)))
            << maze.name << " step " << step.step;
      }
    }
  }
}

TEST(FloodBlock, ResetsWithTheStepAfterItsGoalCell) {
  const auto steps = steps_of(run_of(flood_block_mouse, *capstone_maze(1)), Run::search_run);
  for (const StepRecord& step : steps) EXPECT_EQ(step.pose.cell == Cell(5, 6), step.action.kind == Action::Kind::reset);
}

TEST(FloodExplore, VisitsEveryCellBeforeItResets) {
  EXPECT_EQ(visited_in(run_of(flood_explore_mouse, *capstone_maze(1))), CellSet::all({12, 12}));
}

TEST(FloodExplore, VisitsTheEasternmostColumnFirstAndInItTheNorthernmostCell) {
  const auto steps = steps_of(run_of(flood_explore_mouse, drawn(R"(
                                o---o---o---o
                                |           |
                                o   o   o   o
                                | G         |
                                o   o   o   o
                                | S         |
                                o---o---o---o
                              )")),
                              Run::search_run);
  std::vector<Cell> first_visits;
  CellSet seen;
  for (const StepRecord& step : steps) {
    if (!seen.contains(step.pose.cell)) first_visits.push_back(step.pose.cell);
    seen.insert(step.pose.cell);
  }
  // From the goal (0,1) to the far corner (2,2), down that column, to (1,2) past (1,0), and last to the nearest column.
  EXPECT_THAT(first_visits, ElementsAre(Cell(0, 0), Cell(0, 1), Cell(1, 1), Cell(2, 1), Cell(2, 2), Cell(2, 0),
                                        Cell(1, 0), Cell(1, 2), Cell(0, 2)));
}

TEST(FloodExplore, LooksForEverForACellThatNothingLeadsTo) {
  const RunRecord record = run_of(flood_explore_mouse, drawn(R"(
    o---o---o---o
    | G     |   |
    o   o   o---o
    | S         |
    o---o---o---o
  )"));
  EXPECT_EQ(record.outcome, Outcome::never_reset);
  EXPECT_EQ(record.steps.size(), 1000U);
}

TEST(FloodExplore, NeverResetsWhereTheBudgetDoesNotLastForEveryCell) {
  Rules rules;
  rules.budget = 400;
  EXPECT_EQ(run_of(flood_explore_mouse, *capstone_maze(1), rules).outcome, Outcome::never_reset);
}

TEST(FloodExplore, IsNotReadyInTheLongMazeAfterAThousandSteps) {
  const Maze maze = test::maze_in_file(LABMOUSE_SOURCE_DIR "/mazes/long-16.txt").value();
  const auto outcome = [&](const BuiltinMouse& mouse, int budget) {
    Rules rules;
    rules.budget = budget;
    return run(maze, rules, *mouse.make(brief(maze, rules, 1), Settings(mouse.parameters))).outcome;
  };
  EXPECT_EQ(outcome(flood_explore_mouse, 1000), Outcome::never_reset);
  EXPECT_EQ(outcome(flood_explore_mouse, 2000), Outcome::finished);
  EXPECT_EQ(outcome(flood_block_mouse, 1000), Outcome::finished);
}

}  // namespace
}  // namespace labmouse
