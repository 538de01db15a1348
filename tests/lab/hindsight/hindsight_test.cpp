#include "labmouse/lab/hindsight/hindsight.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "labmouse/chance/rng.hpp"
#include "labmouse/contest/score.hpp"
#include "labmouse/contest/script.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

using Walk = std::vector<Action>;

/// The short way of test::loop(): past the two corners beside the start, four steps.
const Walk short_way = {Action::step(0, 1), Action::step(90, 1), Action::step(-90, 1), Action::step(90, 1)};

/// The long way round the outside, twelve steps. It drives past the short way without a look into it.
const Walk long_way = {Action::step(0, 3),  Action::step(0, 1),   Action::step(90, 3),  Action::step(0, 1),
                       Action::step(90, 3), Action::step(0, 1),   Action::step(90, 2),  Action::step(90, 1),
                       Action::step(90, 1), Action::step(-90, 2), Action::step(-90, 1), Action::step(-90, 1)};

Walk operator+(Walk walk, const Walk& more) {
  walk.insert(walk.end(), more.begin(), more.end());
  return walk;
}
Walk idle(std::size_t steps) { return Walk(steps, Action::step(0, 0)); }
const Walk reset = {Action::reset()};

/// A walk in the loop, and what it scored.
struct Played {
  Played(const Walk& walk, const Rules& of_contest = {}) : rules(of_contest) {
    Script script(maze.size(), walk);
    record = run(maze, rules, script);
  }
  double scored() const { return score(record, rules).value.value(); }
  double stop() const { return best_stop(record, maze, rules); }

  Maze maze = test::loop().maze;
  Rules rules;
  RunRecord record;
};

TEST(BestStop, IsTheGoalWhereNothingIsLearnedAfterwards) {
  const Played played(short_way + idle(3) + reset + short_way);
  EXPECT_DOUBLE_EQ(played.scored(), 4 + 8 / 30.0);
  EXPECT_DOUBLE_EQ(played.stop(), 4 + 5 / 30.0);
}

TEST(BestStop, IsLaterWhereAShorterRouteIsFound) {
  // From the goal back along the short way, which is seen whole two steps later.
  const Walk back = {Action::step(90, 1), Action::step(-90, 1)};
  const Played played(long_way + back + idle(5) + reset + short_way);
  EXPECT_DOUBLE_EQ(played.scored(), 4 + 20 / 30.0);
  EXPECT_DOUBLE_EQ(played.stop(), 4 + 15 / 30.0);
}

TEST(BestStop, PlansOnWhatWasKnown) {
  const Played played(long_way + idle(1) + reset + long_way);
  EXPECT_DOUBLE_EQ(played.scored(), 12 + 14 / 30.0);
  EXPECT_DOUBLE_EQ(played.stop(), 12 + 13 / 30.0);
}

TEST(BestStop, IsItsOwnEndWhereThatWasBetterThanThePlan) {
  const Played played(long_way + reset + short_way);
  EXPECT_DOUBLE_EQ(played.scored(), 4 + 13 / 30.0);
  EXPECT_DOUBLE_EQ(played.stop(), 4 + 13 / 30.0);
}

TEST(BestStop, CountsNoResetBeforeTheGoal) {
  EXPECT_DOUBLE_EQ(Played(reset + short_way + idle(2) + reset + short_way).stop(), 4 + 6 / 30.0);
}

TEST(BestStop, OfAMouseThatDidNotReturnIsWhatItCouldHaveHad) {
  Rules rules;
  rules.budget = 9;
  EXPECT_DOUBLE_EQ(Played(short_way + idle(9), rules).stop(), 4 + 5 / 30.0);
  rules.budget = 8;  // a step too few for the reset and the run
  EXPECT_DOUBLE_EQ(Played(short_way + idle(9), rules).stop(), 100.0);
}

TEST(BestStop, WithoutAGoalIsAFailure) { EXPECT_DOUBLE_EQ(Played(idle(3)).stop(), 100.0); }

TEST(BestStop, WhereTheStartIsAGoalTakesOneStepToRun) {
  const Maze maze(MazeDraft({1, 1}, MazeDraft::Inside::closed));
  Script script(maze.size(), idle(1) + reset + idle(1));
  EXPECT_DOUBLE_EQ(best_stop(run(maze, {}, script), maze, {}), 1 + 2 / 30.0);
}

TEST(BestStop, LiesBetweenBoundAndScore) {
  Rng rng(4);
  for (int i = 0; i < test::tenth(60); ++i) {
    const NamedMaze maze = {"maze",
                            wilson_generator.make({{6 + rng.below(8), 6 + rng.below(8)}, rng.bits(), rng.below(300)})};
    for (const char* mouse : {"flood", "flood-return", "certify", "cautious", "two-way"}) {
      HindsightOrder order;
      order.race.runs = 2;
      order.others = 3;
      const MazeHindsight found = look_back(mouse, {maze}, order).mazes.at(0);
      EXPECT_LE(found.best_stop, found.score) << mouse;
      EXPECT_GE(found.best_stop, *found.bound.score) << mouse;
      EXPECT_LE(found.best_other.value_or(found.score), found.score) << mouse;
      EXPECT_GE(found.best_other.value_or(found.score), *found.bound.score) << mouse;
    }
  }
}

std::vector<Contestant> variants(std::string_view spec, int count, std::uint64_t seed = 1) {
  return perturbed(test::mice(spec).front(), count, seed);
}

TEST(Perturbed, ShiftsNumbersByUpToAQuarter) {
  double least = 1.0, most = 0.0;
  for (const Contestant& variant : variants("visit-counter:coverage=0.9:search=dijkstra:random_share=0.4", 200)) {
    const double share = variant.settings.real("random_share");
    least = std::min(least, share), most = std::max(most, share);
    EXPECT_GE(variant.settings.real("coverage"), 0.675);
    EXPECT_LE(variant.settings.real("coverage"), 1.0);
    EXPECT_EQ(variant.settings.choice("search"), "dijkstra");
  }
  EXPECT_GE(least, 0.3);
  EXPECT_LT(least, 0.31);
  EXPECT_LE(most, 0.5);
  EXPECT_GT(most, 0.49);
}

TEST(Perturbed, ShiftsSmallNumbersByAHundredthOfTheirRange) {
  double most = 0.0;
  for (const Contestant& variant : variants("cautious:explore_frac=0", 100)) {
    EXPECT_GE(variant.settings.real("explore_frac"), 0.0);
    most = std::max(most, variant.settings.real("explore_frac"));
  }
  EXPECT_GT(most, 0.009);
  EXPECT_LE(most, 0.01);
}

TEST(Perturbed, StandOnceEach) {
  std::vector<std::string> names;
  for (const Contestant& variant : variants("flood", 100)) names.push_back(variant.name);
  std::sort(names.begin(), names.end());
  EXPECT_THAT(names, ElementsAre("flood:stride=2", "flood:stride=4"));
}

TEST(Perturbed, BeginsEquallyForAnyCount) {
  const auto few = variants("two-way", 5), many = variants("two-way", 20), others = variants("two-way", 5, 2);
  ASSERT_EQ(few.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(few[i].name, many[i].name);
  EXPECT_NE(few[0].name, others[0].name);
}

TEST(Perturbed, NeedsNumbers) {
  for (const char* spec : {"certify", "potential", "oracle"}) EXPECT_THAT(variants(spec, 9), IsEmpty()) << spec;
}

HindsightOrder order_of(int others, int jobs = 0) {
  HindsightOrder order;
  order.race.runs = 3;
  order.race.jobs = jobs;
  order.others = others;
  return order;
}

std::vector<NamedMaze> mazes() { return {test::loop(), test::without_route(), test::corridor()}; }

TEST(Hindsight, ScoresAsInARaceInTheOrderOfTheMazes) {
  const Hindsight found = look_back("flood:stride=2", mazes(), order_of(0));
  EXPECT_EQ(found.mouse, "flood:stride=2");
  ASSERT_EQ(found.mazes.size(), 2U);
  EXPECT_EQ(found.mazes[0].maze, "loop");
  EXPECT_THAT(found.routeless, ElementsAre("without-route"));
  const Race race = hold_race(test::mice("flood:stride=2"), {test::loop()}, test::in_steps());
  EXPECT_EQ(found.mazes[0].score, race.results[0].score);
  EXPECT_EQ(found.mazes[0].bound.score, race.facts[0].bound);
  EXPECT_FALSE(found.has_others);
  EXPECT_EQ(found.mazes[0].best_other, std::nullopt);
}

TEST(Hindsight, TakesTheBestOfTheMouseAndItsVariants) {
  const Hindsight found = look_back("flood", {test::loop()}, order_of(64));
  const Race race = hold_race(test::mice("flood,flood:stride=2,flood:stride=4"), {test::loop()}, test::in_steps());
  const Standing best = standings_of(race).front();
  EXPECT_EQ(found.mazes[0].best_other, best.mean_all);
  EXPECT_EQ(found.mazes[0].best_mouse, race.mice[best.mouse].name);
}

TEST(Hindsight, OfAMouseThatThrowsDiceTakesFurtherSeeds) {
  const HindsightOrder order = order_of(10);
  const Hindsight found = look_back("random", {test::loop()}, order);
  EXPECT_TRUE(found.is_stochastic);
  RaceOrder race_order = test::in_steps();
  race_order.runs = order.race.runs;
  EXPECT_DOUBLE_EQ(found.mazes[0].score,
                   *standings_of(hold_race(test::mice("random"), {test::loop()}, race_order)).front().mean_all);
  race_order.runs = 3 + 10;
  const Race race = hold_race(test::mice("random"), {test::loop()}, race_order);
  const auto best = std::min_element(race.results.begin(), race.results.end(),
                                     [&](const auto& a, const auto& b) { return a.counted < b.counted; });
  EXPECT_DOUBLE_EQ(*found.mazes[0].best_other, *best->counted);
  EXPECT_EQ(found.mazes[0].best_seed, best->seed);
  double stops = 0.0;
  for (int run = 0; run < 3; ++run) {
    const Maze maze = test::loop().maze;
    const auto mouse = race.mice[0].strategy(maze, brief(maze, {}, contest_seed(1, "loop", run)));
    stops += best_stop(labmouse::run(maze, {}, *mouse), maze, {}) / 3.0;
  }
  EXPECT_DOUBLE_EQ(found.mazes[0].best_stop, stops);
}

TEST(Hindsight, DoesNotDependOnTheNumberOfThreads) {
  for (const char* mouse : {"random", "two-way"}) {
    const std::string alone = json_of(look_back(mouse, mazes(), order_of(20, 1)));
    for (const int jobs : {0, 2, 5}) EXPECT_EQ(json_of(look_back(mouse, mazes(), order_of(20, jobs))), alone) << jobs;
  }
}

TEST(Hindsight, MeansGoOverTheMazes) {
  const Hindsight found = look_back("flood", mazes(), order_of(9));
  const HindsightMeans means = means_of(found);
  EXPECT_DOUBLE_EQ(means.score, (found.mazes[0].score + found.mazes[1].score) / 2);
  EXPECT_DOUBLE_EQ(means.bound, (*found.mazes[0].bound.score + *found.mazes[1].bound.score) / 2);
  EXPECT_DOUBLE_EQ(means.best_stop, (found.mazes[0].best_stop + found.mazes[1].best_stop) / 2);
  EXPECT_DOUBLE_EQ(*means.best_other, (*found.mazes[0].best_other + *found.mazes[1].best_other) / 2);
}

TEST(Hindsight, LeavesOutTheMazeAtWhichItIsStopped) {
  std::atomic<bool> stop = false;
  int contests = 0;
  HindsightHooks hooks;
  hooks.stop = &stop;
  hooks.finished = [&](std::size_t all) {
    EXPECT_EQ(all, 2U * (3 + 10));
    stop = ++contests == 13 + 2;
  };
  const Hindsight found = look_back("random", mazes(), order_of(10, 1), hooks);
  EXPECT_TRUE(found.stopped);
  EXPECT_EQ(found.mazes.size(), 1U);
  EXPECT_THAT(table_of(found, false), Says("Stopped", "1 maze done"));
}

TEST(Hindsight, RefusesWhatIsNoMouse) {
  EXPECT_THAT(look_back("flod", mazes(), {}).error, Says("'flod'", "'flood'"));
  EXPECT_THAT(look_back("flood,certify", mazes(), {}).error, Says("'flood,certify'", "2 mice"));
}

/// Made up.
Hindsight made_up() {
  Hindsight hindsight;
  hindsight.mouse = "two-way";
  hindsight.has_others = true;
  hindsight.mazes = {{"one", {10, 10.5}, 20.0, 18.0, 16.0, "two-way:bias=2", 5},
                     {"two", {12, 12.5}, 30.0, 30.0, 22.5, "two-way", 6}};
  hindsight.routeless = {"three"};
  return hindsight;
}

TEST(HindsightAsTable, CallsReferencesWhatTheyAre) {
  const std::string table = table_of(made_up(), false);
  EXPECT_THAT(table, HasSubstr("\n   bound    score best stop best of 64  maze\n"
                               "  10.500   20.000    18.000     16.000  one\n"
                               "  12.500   30.000    30.000     22.500  two\n"
                               "\n  11.500   25.000    24.000     19.250  mean of 2 mazes\n"));
  EXPECT_THAT(table, Says("references", "not bounds", "64 variants"));
  EXPECT_THAT(table, Says("Left out: three,", "counts 100.\n"));
  EXPECT_THAT(table_of(made_up(), true), HasSubstr("\x1b[1m"));
}

TEST(HindsightAsTable, SaysWhyThereIsNoBestOfSeveral) {
  const std::string table = table_of(look_back("certify", mazes(), order_of(9)), false);
  EXPECT_THAT(table, Says("certify", "no numeric parameters", "no random choices"));
  EXPECT_THAT(table, Not(HasSubstr("best of 9")));
  EXPECT_THAT(table_of(look_back("two-way", mazes(), order_of(0)), false), Not(HasSubstr("best of")));
  EXPECT_THAT(table_of(look_back("random", mazes(), order_of(9)), false), HasSubstr("9 more seeds"));
}

TEST(HindsightAsTable, WarnsWhereAFailureIsCheaperThanTheBound) {
  Hindsight hindsight = made_up();
  hindsight.mazes[0].bound.score = 100.5;
  EXPECT_THAT(table_of(hindsight, false), Says("counts 100,", "less than the bound"));
}

TEST(HindsightAsJson, HasAllNumbers) {
  const auto json = nlohmann::json::parse(json_of(made_up()));
  EXPECT_EQ(json["mouse"], "two-way");
  EXPECT_EQ(json["references"], (nlohmann::json{"best_stop", "best_other"}));
  EXPECT_EQ(json["means"]["best_other"], 19.25);
  EXPECT_EQ(json["mazes"][0]["name"], "one");
  EXPECT_EQ(json["mazes"][0]["best_stop"], 18.0);
  EXPECT_EQ(json["mazes"][0]["best_mouse"], "two-way:bias=2");
  EXPECT_EQ(json["mazes"][0]["best_seed"], 5);
  EXPECT_EQ(json["routeless"][0], "three");
  const auto without = nlohmann::json::parse(json_of(look_back("certify", mazes(), order_of(9))));
  EXPECT_EQ(without["mazes"][0]["best_other"], nullptr);
  EXPECT_EQ(without["others"], 0);
}

}  // namespace
}  // namespace labmouse
