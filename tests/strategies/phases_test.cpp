// The three phases, each with each of its methods.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "labmouse/contest/score.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/maze/routes.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "labmouse/strategies/phases/speed_run.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using Changes = std::map<std::string, std::string>;

Settings settings_with(const Changes& changes) {
  Settings settings(phases_mouse.parameters);
  for (const auto& [name, value] : changes) settings.set(name, value);
  return settings;
}

RunRecord run_with(const Changes& changes, const Maze& maze, const Rules& rules = {}, std::uint64_t seed = 1) {
  return run(maze, rules, *phases_mouse.make(brief(maze, rules, seed), settings_with(changes)));
}

Score score_with(const Changes& changes, const Maze& maze, const Rules& rules = {}) {
  return score(run_with(changes, maze, rules), rules);
}

/// What the mouse knew before each step of its search run, handed to visit(step, knowledge).
template <class Visit>
void replay(const Maze& maze, const RunRecord& record, Visit visit) {
  Knowledge knowledge(maze.size());
  for (const StepRecord& step : record.steps) {
    if (step.run == Run::speed) return;
    ASSERT_TRUE(knowledge.learn(step.pose, step.sighting));
    visit(step, knowledge);
  }
}

bool explored(const Knowledge& knowledge, Cell cell) {
  for (const Heading side : all_headings)
    if (knowledge.state(wall_at(cell, side)) == WallState::unknown) return false;
  return true;
}

int explored_at_reset(const Maze& maze, const RunRecord& record) {
  int cells = 0;
  replay(maze, record, [&](const StepRecord& step, const Knowledge& knowledge) {
    if (step.action.kind != Action::Kind::reset) return;
    CellSet::all(maze.size()).for_each([&](Cell cell) { cells += explored(knowledge, cell) ? 1 : 0; });
  });
  return cells;
}

/// Cells in which the mouse stood in its search run.
CellSet stood_in(const RunRecord& record) {
  CellSet cells;
  for (const StepRecord& step : record.steps)
    if (step.run == Run::search_run) cells.insert(step.pose.cell);
  return cells;
}

Maze loops(std::uint64_t seed) { return prim_generator.make({{12, 12}, seed, 200}); }

// The numbers of the report.

struct Row {
  int maze;
  int search_run;
  int strides;
  int cells;
};

class PhasesInCapstone : public testing::TestWithParam<Row> {
 protected:
  void SetUp() override {
    maze_ = capstone();
    if (!maze_) GTEST_SKIP() << "no file of test maze " << GetParam().maze;
  }
  static std::optional<Maze> capstone() { return test::capstone_maze(GetParam().maze); }

  std::optional<Maze> maze_;
};

TEST_P(PhasesInCapstone, NeedsTheStepsThatItNeeded) {
  const Score result = score_with({}, *maze_);
  EXPECT_EQ(result.search_steps, GetParam().search_run);
  EXPECT_EQ(result.speed_steps, GetParam().strides);
}

TEST_P(PhasesInCapstone, RunsCellByCellOrUpdatingAsItDid) {
  const Score cells = score_with({{"speed", "one-cell"}}, *maze_);
  const Score updating = score_with({{"speed", "strides-updating"}}, *maze_);
  EXPECT_EQ(cells.search_steps, GetParam().search_run);
  EXPECT_EQ(cells.speed_steps, GetParam().cells);
  EXPECT_EQ(updating.search_steps, GetParam().search_run);
  EXPECT_EQ(updating.speed_steps, GetParam().strides);
}

TEST_P(PhasesInCapstone, KnowsAllGoalsAfterTwoMoreSteps) {
  const RunRecord record = run_with({{"continuing", "all-goals"}}, *maze_);
  EXPECT_EQ(score(record, {}).search_steps, GetParam().search_run + 2);
  replay(*maze_, record, [&](const StepRecord& step, const Knowledge& knowledge) {
    if (step.action.kind != Action::Kind::reset) return;
    maze_->goals().for_each(
        [&](Cell goal) { EXPECT_TRUE(stood_in(record).contains(goal) || explored(knowledge, goal)); });
  });
}

INSTANTIATE_TEST_SUITE_P(Report, PhasesInCapstone,
                         testing::Values(Row{1, 61, 17, 30}, Row{2, 170, 22, 43}, Row{3, 228, 25, 49}),
                         [](const auto& row) { return "Maze" + std::to_string(row.param.maze); });

// Searching.

class OneStepSearch : public testing::TestWithParam<const char*> {};

TEST_P(OneStepSearch, GoesOneCellLeftAheadOrRightAndTurnsRightInDeadEnds) {
  const Maze maze = depth_first_generator.make({{12, 12}, 4, 50});
  replay(maze, run_with({{"searching", GetParam()}}, maze), [](const StepRecord& step, const Knowledge&) {
    if (step.action.kind != Action::Kind::step) return;
    const Sighting& seen = step.sighting;
    if (seen.left + seen.ahead + seen.right == 0) {
      EXPECT_EQ(step.action, Action::step(90, 0));
    } else {
      EXPECT_EQ(step.action.movement, 1);
      EXPECT_FALSE(step.blocked);
    }
  });
}

TEST_P(OneStepSearch, ThrowsDiceUnlessItFollowsTheWall) {
  const bool by_chance = std::string_view(GetParam()) != "wall-follower";
  EXPECT_EQ(phases_mouse.uses_chance(settings_with({{"searching", GetParam()}})), by_chance);
  const Changes changes = {{"searching", GetParam()}};
  EXPECT_EQ(run_with(changes, loops(1), {}, 1) != run_with(changes, loops(1), {}, 2), by_chance);
}

INSTANTIATE_TEST_SUITE_P(Phases, OneStepSearch,
                         testing::Values("random", "weighted", "unexplored-cell", "unexplored-space", "wall-follower"),
                         [](const auto& name) {
                           std::string word = name.param;
                           std::replace(word.begin(), word.end(), '-', '_');
                           return word;
                         });

/// How often each way was taken where all three were open: left, ahead, right.
std::array<int, 3> turns_at_crossings(const Changes& changes) {
  std::array<int, 3> turns{};
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Maze maze = kruskal_generator.make({{16, 16}, seed, 1000});
    for (const StepRecord& step : run_with(changes, maze, {}, seed).steps)
      if (step.run == Run::search_run && step.sighting.left > 0 && step.sighting.ahead > 0 && step.sighting.right > 0 &&
          step.action.movement == 1)
        ++turns[static_cast<std::size_t>(step.action.rotation / 90 + 1)];
  }
  return turns;
}

double share(const std::array<int, 3>& turns, std::size_t way) {
  return static_cast<double>(turns[way]) / (turns[0] + turns[1] + turns[2]);
}

TEST(PhasesSearching, RandomTurnsAreEquallyLikely) {
  const auto turns = turns_at_crossings({{"searching", "random"}});
  for (const std::size_t way : {0U, 1U, 2U}) EXPECT_NEAR(share(turns, way), 1.0 / 3, 0.03);
}

TEST(PhasesSearching, WeightedTurnsAreAsLikelyAsTheirWeights) {
  const auto turns = turns_at_crossings({{"searching", "weighted"}, {"weights", "1/6/3"}});
  EXPECT_NEAR(share(turns, 0), 0.1, 0.03);
  EXPECT_NEAR(share(turns, 1), 0.6, 0.03);
  EXPECT_NEAR(share(turns, 2), 0.3, 0.03);
}

TEST(PhasesSearching, WithoutAnyWeightTheWaysAreEquallyLikely) {
  const auto turns = turns_at_crossings({{"searching", "weighted"}, {"weights", "0/0/0"}});
  for (const std::size_t way : {0U, 1U, 2U}) EXPECT_NEAR(share(turns, way), 1.0 / 3, 0.03);
}

TEST(PhasesSearching, UnexploredCellGoesWhereACellIsUnexploredIfAnyIs) {
  int choices = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RunRecord record = run_with({{"searching", "unexplored-cell"}}, loops(seed));
    replay(loops(seed), record, [&](const StepRecord& step, const Knowledge& knowledge) {
      if (step.action.movement == 0) return;
      int fresh = 0, known = 0;
      for (const int quarters : {-1, 0, 1}) {
        if (step.sighting.towards(quarters) == 0) continue;
        ++(explored(knowledge, neighbour(step.pose.cell, turned(step.pose.heading, quarters))) ? known : fresh);
      }
      if (fresh == 0 || known == 0) return;
      ++choices;
      EXPECT_FALSE(explored(knowledge, after(step.pose, step.action).cell));
    });
  }
  EXPECT_GT(choices, 50);
}

/// Unexplored cells that the mouse knows a way to through the neighbour on that side, not coming back through its cell.
int unexplored_behind(const Knowledge& knowledge, Cell here, Heading side) {
  CellSet found;
  std::vector<Cell> open = {neighbour(here, side)};
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    if (cell == here || found.contains(cell)) continue;
    found.insert(cell);
    for (const Heading way : all_headings)
      if (knowledge.open().contains(wall_at(cell, way))) open.push_back(neighbour(cell, way));
  }
  int cells = 0;
  found.for_each([&](Cell cell) { cells += explored(knowledge, cell) ? 0 : 1; });
  return cells;
}

TEST(PhasesSearching, UnexploredSpaceGoesOnlyWhereSomethingIsUnexploredIfAnythingIs) {
  int choices = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RunRecord record = run_with({{"searching", "unexplored-space"}}, loops(seed));
    replay(loops(seed), record, [&](const StepRecord& step, const Knowledge& knowledge) {
      if (step.action.movement == 0) return;
      int empty = 0, full = 0;
      for (const int quarters : {-1, 0, 1})
        if (step.sighting.towards(quarters) > 0)
          ++(unexplored_behind(knowledge, step.pose.cell, turned(step.pose.heading, quarters)) > 0 ? full : empty);
      if (empty == 0 || full == 0) return;
      ++choices;
      EXPECT_GT(unexplored_behind(knowledge, step.pose.cell, after(step.pose, step.action).heading), 0);
    });
  }
  EXPECT_GT(choices, 50);
}

TEST(PhasesSearching, TheWallFollowerWalksAsWallLeftDoes) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Maze maze = wilson_generator.make({{10, 10}, seed, 0});
    const RunRecord other = run(maze, {}, *wall_left_mouse.make(brief(maze, {}, 1), Settings()));
    EXPECT_EQ(run_with({{"searching", "wall-follower"}}, maze), other);
  }
}

/// A fork: to the west an unexplored cell, one move to the east three more, nearer to the goal.
Maze fork() {
  return test::drawn(R"(
    o---o---o---o---o---o---o---o
    |                         G |
    o   o   o---o---o---o   o   o
    |         S             |   |
    o---o---o---o---o---o---o---o
  )");
}

Action first_action(const Changes& changes, const Maze& maze) { return run_with(changes, maze).steps.front().action; }

TEST(PhasesSearching, TheHeuristicDecidesBetweenNearAndTowardsTheGoal) {
  EXPECT_EQ(first_action({{"heuristic", "none"}}, fork()), Action::step(-90, 2));
  EXPECT_EQ(first_action({{"heuristic", "manhattan"}}, fork()), Action::step(90, 3));
  EXPECT_EQ(first_action({{"heuristic", "manhattan-edges"}}, fork()), Action::step(90, 3));
}

// Continuing.

TEST(PhasesContinuing, AllGoalsGoesIntoNeighboursOnly) {
  CellSet goals;
  for (const Cell goal : {Cell{0, 3}, Cell{2, 0}, Cell{3, 3}}) goals.insert(goal);
  const Maze maze = test::drawn(R"(
    o---o---o---o---o
    |       |   |   |
    o   o---o   o---o
    |               |
    o   o   o---o   o
    |   |   |       |
    o   o---o   o   o
    | S |       |   |
    o---o---o---o---o
  )")
                        .with_goals(goals);
  const RunRecord record = run_with({{"continuing", "all-goals"}}, maze);
  EXPECT_EQ(record.outcome, Outcome::finished);
  EXPECT_EQ(record, run_with({}, maze));
}

TEST(PhasesContinuing, CoverageEndsAtItsShare) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Maze maze = loops(seed);
    const RunRecord at_once = run_with({}, maze);
    EXPECT_EQ(run_with({{"continuing", "coverage"}, {"coverage", "0"}}, maze), at_once);
    const int before = explored_at_reset(maze, at_once);
    for (const int percent : {50, 75, 100}) {
      const std::string share_of_cells = std::to_string(percent / 100.0);
      const RunRecord record = run_with({{"continuing", "coverage"}, {"coverage", share_of_cells}}, maze);
      EXPECT_GE(explored_at_reset(maze, record) * 100, percent * maze.size().area());
      if (before * 100 >= percent * maze.size().area()) {
        EXPECT_EQ(record, at_once);
      } else {
        EXPECT_GT(record.steps.size(), at_once.steps.size());
      }
    }
  }
}

TEST(PhasesContinuing, CoverageEndsWhereNoMoreCanBeReached) {
  const Maze maze = test::drawn(R"(
    o---o---o---o
    |       |   |
    o   o   o   o
    | G     |   |
    o   o---o   o
    | S |   |   |
    o---o---o---o
  )");
  EXPECT_EQ(score_with({{"continuing", "coverage"}, {"coverage", "1"}}, maze).outcome, Outcome::finished);
}

TEST(PhasesContinuing, EndsWhileTheBudgetStillAllowsTheKnownRoute) {
  const Maze maze = depth_first_generator.make({{16, 16}, 6, 100});
  const Score at_once = score_with({}, maze);
  for (const char* continuing : {"coverage", "worthwhile"}) {
    const Changes changes = {{"continuing", continuing}, {"coverage", "1"}};
    Rules rules;
    for (rules.budget = at_once.search_steps + at_once.speed_steps; rules.budget < 400;
         rules.budget += test::sanitized ? 70 : 7)
      EXPECT_EQ(score_with(changes, maze, rules).outcome, Outcome::finished) << rules.budget;
  }
}

TEST(PhasesContinuing, WorthwhileEndsWithAShortestRun) {
  int gained = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Maze maze = loops(seed);
    const Score worthwhile = score_with({{"continuing", "worthwhile"}}, maze), none = score_with({}, maze);
    EXPECT_EQ(worthwhile.speed_steps, shortest_in_strides(maze)->strides) << seed;
    EXPECT_GE(worthwhile.search_steps, none.search_steps) << seed;
    gained += none.speed_steps - worthwhile.speed_steps;
    const Score cells = score_with({{"continuing", "worthwhile"}, {"speed", "one-cell"}}, maze);
    EXPECT_EQ(cells.speed_steps, *shortest_in_cells(maze)) << seed;
  }
  EXPECT_GT(gained, 0);
}

TEST(PhasesContinuing, WorthwhileLeavesOutWhatHasToBeLeftWhereItWasEntered) {
  // The left hand leads once around the room: all its walls are seen, and its only door, which lies at the goal. What
  // can matter lies behind the start.
  const Maze maze = test::drawn(R"(
    o---o---o---o---o---o
    |                   |
    o   o---o---o---o   o
    |   |           |   |
    o   o   o   o   o   o
    |   |           |   |
    o   o   o   o   o   o
    |   |           |   |
    o   o   o---o---o   o
    | S | G             |
    o   o   o---o---o---o
    |       |           |
    o---o---o---o---o---o
  )");
  const auto cells_of_the_room = [&](const Changes& changes) {
    int cells = 0;
    stood_in(run_with(changes, maze)).for_each([&](Cell cell) {
      cells += cell.x >= 1 && cell.x <= 3 && cell.y >= 2 && cell.y <= 4 ? 1 : 0;
    });
    return cells;
  };
  const Changes worthwhile = {{"searching", "wall-follower"}, {"continuing", "worthwhile"}};
  EXPECT_EQ(cells_of_the_room(worthwhile), 0);
  EXPECT_EQ(score_with(worthwhile, maze).speed_steps, 3);
  EXPECT_GT(cells_of_the_room({{"continuing", "coverage"}, {"coverage", "0.8"}}), 0);
}

// The speed run.

TEST(PhasesSpeedRun, PlansAnewOnlyWhereItUpdates) {
  //   o---o---o---o
  //   | G         |
  //   o   o---o   o   the way in the west is not known when the route is planned
  //   | S         |
  //   o---o---o---o
  Briefing briefing;
  briefing.size = {3, 2};
  briefing.goals.insert({0, 1});
  for (const auto& [speed, first] :
       {std::pair{"strides", Action::step(90, 2)}, {"strides-updating", Action::step(0, 1)}}) {
    Knowledge knowledge(briefing.size);
    ASSERT_TRUE(knowledge.learn({{2, 0}, Heading::west}, {0, 2, 1}));
    ASSERT_TRUE(knowledge.learn({{2, 1}, Heading::west}, {1, 2, 0}));
    SpeedRun speed_run(briefing, settings_with({{"speed", speed}}));
    EXPECT_EQ(speed_run.length(knowledge), 3);
    speed_run.plan(knowledge);
    ASSERT_TRUE(knowledge.learn(briefing.start, {0, 1, 2}));
    EXPECT_EQ(speed_run.next(knowledge, briefing.start), first) << speed;
  }
}

TEST(PhasesSpeedRun, GoesOneCellAStepWhereItIsToldSo) {
  for (const StepRecord& step : run_with({{"speed", "one-cell"}}, loops(2)).steps)
    if (step.run == Run::speed) {
      EXPECT_EQ(std::abs(step.action.movement), 1);
    }
}

}  // namespace
}  // namespace labmouse
