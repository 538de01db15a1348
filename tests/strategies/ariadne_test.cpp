// ariadne against its definition, decision by decision, and what it promises of whole contests.
#include <gtest/gtest.h>

#include "labmouse/contest/score.hpp"
#include "labmouse/maze/routes.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/allocations.hpp"
#include "tests/strategies/ariadne_referee.hpp"
#include "tests/strategies/counting_mouse.hpp"
#include "tests/strategies/one_contest.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

using test::any_maze;
using test::AriadneReferee;
using test::drawing_of;
using test::Values;

Settings settings_of(const Values& values) {
  Settings settings(ariadne_mouse.parameters);
  for (const auto& [name, value] : values) settings.set(name, value);
  return settings;
}

/// With these it stops where nothing unseen can be shorter, as certify does.
const Values proof = {
    {"prior", "uniform"}, {"model", "free"}, {"style", "contest"}, {"stop_travel", "0"}, {"stop_margin", "0"}};

struct RefereedRun {
  RunRecord record;
  bool stopped_content = false, stopped_at_the_goal = false;
};

Briefing with_reasons(Briefing briefing) {
  briefing.reasons = true;
  return briefing;
}

RefereedRun refereed(const Maze& maze, const Settings& settings, const Rules& rules = {}) {
  const Briefing briefing = with_reasons(brief(maze, rules, 1));
  const auto mouse = ariadne_mouse.make(briefing, settings);
  AriadneReferee referee(*mouse, briefing, settings);
  RunRecord record = run(maze, rules, referee);
  return {std::move(record), referee.stopped_content(), referee.stopped_at_the_goal()};
}

/// Rules and settings of all sorts; most often the default ones.
Rules any_rules(Rng& rng) {
  Rules rules;
  rules.stride = 1 + rng.below(4);
  if (rng.chance(1, 4)) rules.budget = 1 + rng.below(150);
  return rules;
}

Settings any_settings(Rng& rng) {
  static const Values several[] = {{{"style", "contest"}},
                                   {{"style", "loop-free"}},
                                   {{"prior", "uniform"}, {"way_here", "0.13"}},
                                   {{"way_here", "1"}},
                                   {{"model", "flat"}},
                                   {{"model", "classes"}},
                                   {{"closed", "0.4"}, {"closed_after", "0.5"}},
                                   {{"stop_margin", "-60"}},
                                   {{"travel", "1"}, {"insight", "50"}, {"goal_bonus", "0"}},
                                   {{"travel_after", "1"}, {"insight_after", "50"}, {"stop_travel", "0"}},
                                   proof};
  return settings_of(rng.chance(1, 2) ? Values{} : several[rng.below(static_cast<int>(std::size(several)))]);
}

TEST(Ariadne, DecidesAsItsDefinitionSaysInMazesByDice) {
  Rng rng(1000);
  for (int i = 0; i < test::some_of(1000); ++i) {
    const Maze maze = any_maze(rng, i % 8 == 0 ? 16 : 9);
    const Rules rules = any_rules(rng);
    const RefereedRun run = refereed(maze, any_settings(rng), rules);
    for (const StepRecord& step : run.record.steps) ASSERT_FALSE(step.blocked) << i << drawing_of(maze);
    ASSERT_FALSE(HasFailure()) << "maze " << i << ", stride " << rules.stride << ", budget " << rules.budget
                               << drawing_of(maze);
  }
}

TEST(Ariadne, DecidesSoInTheLargestMazes) {
  for (const Size size : {Size{64, 64}, Size{64, 1}, Size{3, 64}, Size{32, 32}}) {
    const Maze maze =
        kruskal_generator.make({size, 5, 100}).with_start({size.width - 1, size.height - 1}, Heading::south);
    Rules rules;
    rules.budget = test::tenth(60);
    refereed(maze, settings_of({}), rules);
    ASSERT_FALSE(HasFailure()) << size.width << "x" << size.height;
  }
}

/// The steps of the best run.
std::optional<int> shortest(const Maze& maze, const Rules& rules) {
  const auto runs = shortest_in_strides(maze, rules.stride);
  return runs ? std::optional(std::max(1, runs->strides)) : std::nullopt;
}

TEST(Ariadne, RunsShortestWhereItStopsOnlyForAProof) {
  Rng rng(7);
  const Settings settings = settings_of(proof);
  Rules rules;
  rules.budget = 100'000;
  int proven = 0;
  constexpr int mazes = test::tenth(400);
  for (int i = 0; i < mazes; ++i) {
    const Maze maze = any_maze(rng, 20);
    rules.stride = 1 + i % 4;
    const Score result = score(run(maze, rules, *ariadne_mouse.make(brief(maze, rules, 1), settings)), rules);
    ASSERT_EQ(result.outcome == Outcome::finished, shortest(maze, rules).has_value()) << i << drawing_of(maze);
    if (result.outcome != Outcome::finished) continue;
    ++proven;
    ASSERT_EQ(result.speed_steps, shortest(maze, rules)) << i << drawing_of(maze);
  }
  EXPECT_GT(proven, mazes * 3 / 4);
}

TEST(Ariadne, SolvesEveryMazeWithARouteAndGivesUpWhereThereIsNone) {
  Rng rng(12);
  Rules rules;
  rules.budget = 1'000'000;
  for (int i = 0; i < test::tenth(400); ++i) {
    const Maze maze = any_maze(rng, i % 10 == 0 ? 40 : 16);
    rules.stride = 1 + i % 4;
    const RunRecord record = test::contest(ariadne_mouse, maze, {}, 1, rules);
    ASSERT_EQ(record.outcome, shortest(maze, rules) ? Outcome::finished : Outcome::forfeit) << i << drawing_of(maze);
    if (record.outcome == Outcome::forfeit) {
      ASSERT_EQ(record.steps.back().action.reason, ForfeitReason::no_route);
    }
  }
}

TEST(Ariadne, FinishesWithinTheBudgetWhereTheCarefulOnesDo) {
  Rng rng(300);
  for (int i = 0; i < test::tenth(300); ++i) {
    const Maze maze = any_maze(rng, i % 20 == 0 ? 64 : 24);
    const auto solves = [&](const BuiltinMouse& mouse) {
      return test::contest(mouse, maze).outcome == Outcome::finished;
    };
    const bool can_be_done = solves(certify_mouse) || solves(flood_return_mouse);
    ASSERT_TRUE(solves(ariadne_mouse) || !can_be_done) << i << drawing_of(maze);
  }
}

/// The most steps that were ever left over when a run was known: to the goal, the reset, and the run.
int most_to_spare(const Maze& maze, const RunRecord& record, const Rules& rules) {
  DistanceField to_goal(maze.size(), strides(rules.stride));
  bool entered = false;
  int most = -unreachable;
  test::follow_search_run(maze, record, [&](const StepRecord& step, const Knowledge& knowledge) {
    entered = entered || (step.step > 1 && maze.is_goal(step.pose.cell));
    to_goal.fill(knowledge.open(), maze.goals());
    const int run = std::max(1, to_goal.at(maze.start()));
    const int there = entered ? 0 : std::max(1, to_goal.at(step.pose.cell));
    most = std::max(most, rules.budget - (step.step - 1) - (there + 1 + run));
  });
  return most;
}

TEST(Ariadne, HoldsToARunThatIsKnownToFitIntoTheBudget) {
  Rng rng(11);
  int failed = 0;
  constexpr int mazes = test::tenth(300);
  for (int i = 0; i < mazes; ++i) {
    const Maze maze = any_maze(rng, 12);
    Rules rules;
    rules.stride = 1 + i % 4;
    for (rules.budget = 1; rules.budget < 100; rules.budget += 1 + rules.budget / 8) {
      const RunRecord record = test::contest(ariadne_mouse, maze, {}, 1, rules);
      if (record.outcome == Outcome::finished) continue;
      ++failed;
      ASSERT_LT(most_to_spare(maze, record, rules), 1) << i << ", budget " << rules.budget << drawing_of(maze);
    }
  }
  EXPECT_GT(failed, mazes * 3);
}

TEST(Ariadne, StepsIntoTheGoalThatItStandsIn) {
  const Maze maze = test::drawn(R"(
    o---o---o
    |       |
    o---o   o
    | S |   |
    o---o---o
  )");
  const RunRecord record = test::contest(ariadne_mouse, maze.with_goals(CellSet::of({0, 0})));
  ASSERT_EQ(record.outcome, Outcome::finished);
  EXPECT_EQ(record.steps.size(), 3U);
}

TEST(Ariadne, GivesUpWhereTheStartIsClosedIn) {
  const Maze maze = test::drawn(R"(
    o---o---o
    |     G |
    o---o   o
    | S |   |
    o---o---o
  )");
  const RunRecord record = test::contest(ariadne_mouse, maze);
  EXPECT_EQ(record.outcome, Outcome::forfeit);
  EXPECT_EQ(record.steps.size(), 1U);
}

TEST(Ariadne, LooksBehindItBeforeItGivesUp) {
  const Maze maze = test::drawn(R"(
    o---o---o
    | S | G |
    o   o   o
    |       |
    o---o---o
  )");
  const RunRecord record = test::contest(ariadne_mouse, maze);
  ASSERT_EQ(record.outcome, Outcome::finished);
  EXPECT_EQ(record.steps.front().action, Action::step(90, 0));
}

TEST(Ariadne, NeedsNoMoreThanTheWayThereAndTheRunInACorridor) {
  for (int cells = 2; cells <= 64; ++cells) {
    const Size size = {1, cells};
    const Maze maze = Maze(MazeDraft(size, MazeDraft::Inside::open)).with_goals(CellSet::of({0, cells - 1}));
    Rules rules;
    rules.budget = 2 * ((cells - 1 + 2) / 3) + 1;
    EXPECT_EQ(test::contest(ariadne_mouse, maze, {}, 1, rules).outcome, Outcome::finished) << cells;
  }
}

RunRecord in_style(std::string_view style, const Maze& maze) {
  return test::contest(ariadne_mouse, maze, {{"style", style}});
}

TEST(Ariadne, StopsAtTheGoalOfAMazeWithoutLoops) {
  int earlier = 0;  // than it would otherwise
  constexpr int mazes = test::tenth(40);
  for (std::uint64_t seed = 1; seed <= mazes; ++seed) {
    const Maze maze = depth_first_generator.make({{16, 16}, seed, 0});
    EXPECT_EQ(in_style("auto", maze), in_style("loop-free", maze)) << seed;
    earlier += in_style("auto", maze) != in_style("contest", maze) ? 1 : 0;
  }
  EXPECT_GT(earlier, mazes / 2);
}

TEST(Ariadne, ResetsInTheGoalWhereItIsToldThatThereAreNoLoops) {
  const Maze maze = contest_generator.make({{16, 16}, 1, 0});
  EXPECT_TRUE(refereed(maze, settings_of({{"style", "loop-free"}})).stopped_at_the_goal);
  for (const StepRecord& step : in_style("loop-free", maze).steps)
    if (step.action.kind == Action::Kind::reset) {
      EXPECT_TRUE(maze.is_goal(step.pose.cell));
    }
}

TEST(Ariadne, GoesOnBeyondTheGoalOfAContestMaze) {
  int mazes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(LABMOUSE_SOURCE_DIR "/mazes")) {
    if (!entry.path().filename().string().starts_with("contest-")) continue;
    const auto maze = test::maze_in_file(entry.path());
    ASSERT_TRUE(maze) << entry.path();
    EXPECT_EQ(in_style("auto", *maze), in_style("contest", *maze)) << entry.path();
    ++mazes;
  }
  EXPECT_GT(mazes, 0);
}

TEST(Ariadne, FitsIntoASmallComputer) {
  const auto bytes = [](int side) {
    const Briefing briefing = brief(Maze(MazeDraft({side, side}, MazeDraft::Inside::open)), {}, 1);
    const Settings settings = settings_of({});
    const long before = test::allocated_bytes();
    const auto mouse = ariadne_mouse.make(briefing, settings);
    return test::allocated_bytes() - before;
  };
  EXPECT_LE(bytes(16), 16 * 1024);
  for (const int side : {16, 32, 64}) RecordProperty("bytes_" + std::to_string(side), static_cast<int>(bytes(side)));
}

TEST(Ariadne, TakesNoMoreMemoryForItsReasons) {
  Rng rng(66);
  for (int i = 0; i < 60; ++i) {
    const Maze maze = i == 0 ? kruskal_generator.make({{64, 64}, 5, 100}) : any_maze(rng, 20);
    const auto mouse = ariadne_mouse.make(with_reasons(brief(maze, {}, 1)), any_settings(rng));
    test::CountingMouse counting(*mouse);
    run(maze, {}, counting);
    ASSERT_EQ(counting.allocations(), 0) << drawing_of(maze);
  }
}

TEST(Ariadne, DoesTheSameWhetherItKeepsItsReasonsOrNot) {
  Rng rng(55);
  for (int i = 0; i < test::tenth(200); ++i) {
    const Maze maze = any_maze(rng, i % 10 == 0 ? 40 : 16);
    const Rules rules = any_rules(rng);
    const Settings settings = any_settings(rng);
    const auto silent = ariadne_mouse.make(brief(maze, rules, 1), settings),
               talks = ariadne_mouse.make(with_reasons(brief(maze, rules, 1)), settings);
    ASSERT_EQ(run(maze, rules, *silent).steps, run(maze, rules, *talks).steps) << i;
    ASSERT_EQ(silent->reasons(), nullptr);
  }
}

TEST(Ariadne, HasNothingLeftToHopeForWhereItStops) {
  Rng rng(56);
  int stopped = 0;
  for (int i = 0; i < 50; ++i) {
    const Maze maze = any_maze(rng, 16);
    const auto mouse = ariadne_mouse.make(with_reasons(brief(maze, {}, 1)), settings_of({{"style", "contest"}}));
    for (const StepRecord& step : test::contest(ariadne_mouse, maze, {{"style", "contest"}}).steps) {
      ASSERT_EQ(mouse->decide(step.sighting), step.action);
      if (step.action.kind != Action::Kind::reset) continue;
      ++stopped;
      ASSERT_NE(mouse->reasons(), nullptr);
      ASSERT_EQ(mouse->reasons()->chosen, -1);
      const Reasons& reasons = *mouse->reasons();
      if (reasons.candidates.empty()) continue;
      // What a look may cost more than it could save: 2.67 thirtieths of a step.
      ASSERT_GE(reasons.hope + reasons.price, reasons.known + 2.66);
    }
  }
  EXPECT_GT(stopped, 30);
}

}  // namespace
}  // namespace labmouse
