#include "labmouse/lab/studies/tune.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/drive/drive_worlds.hpp"
#include "labmouse/lab/numbers/maze_interval.hpp"
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "tests/lab/drawing/drawing_samples.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/lab/records/drive_record_fixture.hpp"
#include "tests/lab/xml_scanner.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(Variant, TakesSeveralValuesAtOnce) {
  const std::vector<Setting> values = {{"coverage", "0.50"}, {"random_share", "0.1"}};
  const SpecResult result = read_variant("visit-counter:coverage=0.9:search=dijkstra", values);
  ASSERT_EQ(result.contestants.size(), 1U) << result.error;
  EXPECT_EQ(result.contestants.front().name, "visit-counter:random_share=0.1:coverage=0.5:search=dijkstra");
}

TuneOrder order_of(int evaluations, int population = 5) {
  TuneOrder order;
  order.race = test::in_steps();
  order.race.runs = 3;
  order.evaluations = evaluations;
  order.population = population;
  return order;
}

std::vector<NamedMaze> mazes() { return {test::loop(), test::corridor(), test::without_route()}; }

Tune tune(std::string_view spec, std::string_view parameters, const TuneOrder& order, const TuneHooks& hooks = {}) {
  const RangesResult ranges = read_ranges(spec, parameters);
  EXPECT_EQ(ranges.error, "");
  return hold_tune(spec, ranges.ranges, mazes(), order, hooks);
}

constexpr const char* both = "random_share,coverage=0.2:0.9";

TEST(Tune, BeginsWithTheMouseAsGiven) {
  const Tune found = tune("visit-counter:random_share=0.25", both, order_of(1));
  ASSERT_EQ(found.evaluations.size(), 1U);
  const Evaluation& given = found.evaluations.front();
  EXPECT_EQ(given.mouse, "visit-counter:random_share=0.25");
  EXPECT_THAT(given.values, ElementsAre("0.25", "0.8333"));
  EXPECT_EQ(given.generation, 0);
  ASSERT_EQ(given.by_maze.size(), 3U);
  EXPECT_EQ(given.by_maze[2], std::nullopt);  // without a route
  EXPECT_EQ(found.mazes, 2U);
  EXPECT_EQ(found.routeless, 1);
  EXPECT_FALSE(found.stopped);
}

TEST(Tune, EvaluatesEachCandidateAsItIsWritten) {
  const TuneOrder order = order_of(14);
  const Tune found = tune("visit-counter", both, order);
  ASSERT_EQ(found.evaluations.size(), 14U);
  for (const Evaluation& evaluation : found.evaluations) {
    const Race race = hold_race(test::mice(evaluation.mouse), mazes(), order.race);
    const Standing standing = standings_of(race).front();
    EXPECT_DOUBLE_EQ(evaluation.value, standing.mean_all.value()) << evaluation.mouse;
    EXPECT_EQ(evaluation.failures, standing.runs - standing.finished);
    EXPECT_EQ(race.mice.front().settings.choice("random_share"), evaluation.values[0]);
    EXPECT_EQ(race.mice.front().settings.choice("coverage"), evaluation.values[1]);
    EXPECT_GE(race.mice.front().settings.real("coverage"), 0.2);
    EXPECT_LE(race.mice.front().settings.real("coverage"), 0.9);
  }
}

TEST(Tune, CountsGenerationsOfTheGivenSizeAndARest) {
  std::vector<std::size_t> sizes;
  TuneHooks hooks;
  hooks.generation = [&](const Tune& so_far) { sizes.push_back(so_far.evaluations.size()); };
  const Tune found = tune("visit-counter", both, order_of(13), hooks);
  EXPECT_THAT(sizes, ElementsAre(1, 6, 11, 13));
  EXPECT_EQ(found.evaluations[5].generation, 1);
  EXPECT_EQ(found.evaluations[6].generation, 2);
  EXPECT_EQ(found.evaluations[12].generation, 3);
  EXPECT_DOUBLE_EQ(found.evaluations[1].step, 0.2);
}

TEST(Tune, FindsBetterValues) {
  LABMOUSE_SKIP_SANITIZED();
  TuneOrder order = order_of(60);
  order.race.runs = 10;
  // Only chance marks cells: little of it and a full visit are bad, and one can have more and less.
  const Tune found = tune("visit-counter:random_share=0.05:coverage=0.9", "random_share,coverage", order);
  EXPECT_LT(best_of(found).value, found.evaluations.front().value / 2.0);
  EXPECT_GT(std::stod(best_of(found).values[0]), 0.1);
  double late = 0.0;  // the last generations on average, not one lucky candidate
  for (std::size_t i = 50; i < 60; ++i) late += found.evaluations[i].value / 10.0;
  EXPECT_LT(late, found.evaluations.front().value / 1.5);
}

TEST(Tune, BeginsAtTheNearestValueInTheRange) {
  TuneOrder order = order_of(6);
  order.step = 0.001;
  const Tune found = tune("cautious:explore_frac=0.9", "explore_frac=0.2:0.5", order);
  EXPECT_EQ(found.evaluations[0].values[0], "0.9");
  for (std::size_t i = 1; i < 6; ++i) EXPECT_NEAR(std::stod(found.evaluations[i].values[0]), 0.5, 0.002);
}

TEST(Tune, RacesTheSameCandidateOnce) {
  int contests = 0;
  std::size_t expected = 0;
  TuneHooks hooks;
  hooks.finished = [&](std::size_t all) {
    ++contests;
    expected = all;
  };
  const Tune found = tune("flood", "stride=2:3", order_of(17), hooks);
  EXPECT_EQ(found.evaluations.size(), 17U);
  EXPECT_EQ(contests, 2 * 3);  // two values in three mazes
  EXPECT_GE(expected, 6U);
}

TEST(Tune, ExpectsAllContestsFromTheFirst) {
  std::vector<std::size_t> expected;
  TuneHooks hooks;
  hooks.finished = [&](std::size_t all) { expected.push_back(all); };
  tune("visit-counter", both, order_of(13), hooks);
  EXPECT_EQ(expected, std::vector<std::size_t>(13U * 9, 13U * 9));  // nine contests each, and no candidate twice
}

TEST(Tune, TakesTheFirstAmongEquals) {
  const Tune found = tune("flood", "stride=2:3", order_of(9));
  for (const Evaluation& evaluation : found.evaluations) {
    if (&evaluation == &best_of(found)) break;
    EXPECT_GT(evaluation.value, best_of(found).value);
  }
}

TEST(Tune, MayTuneTheRatioToTheBound) {
  TuneOrder order = order_of(1);
  const Tune scores = tune("flood", "stride", order);
  order.objective = Objective::ratio;
  const Tune ratios = tune("flood", "stride", order);
  // Mazes in the order of their names: corridor, loop.
  const std::vector<double> bounds = {*bound_of(test::corridor().maze, Rules()).score,
                                      *bound_of(test::loop().maze, Rules()).score};
  const auto &by_score = scores.evaluations[0].by_maze, &by_ratio = ratios.evaluations[0].by_maze;
  for (std::size_t maze : {0U, 1U}) EXPECT_DOUBLE_EQ(*by_ratio[maze], *by_score[maze] / bounds[maze]);
  EXPECT_DOUBLE_EQ(ratios.evaluations[0].value, (*by_ratio[0] + *by_ratio[1]) / 2.0);
}

TEST(Tune, RefusesRatiosToABoundOfZero) {
  TuneOrder order = order_of(1);
  order.objective = Objective::ratio;
  order.race.world = seconds_world(find_rules("coverage").rules, test::drive_model("kerise"));
  // One dead end, and a goal beside the start.
  const NamedMaze branch = {"branch", test::drawn(R"(
    o---o---o
    |   | G |
    o   o   o
    | S     |
    o---o---o
  )")};
  const Tune refused = hold_tune("flood", read_ranges("flood", "stride").ranges, {branch}, order);
  EXPECT_THAT(refused.error, Says("'branch'", "is 0", "score"));
  EXPECT_THAT(refused.evaluations, IsEmpty());
}

TEST(Tune, CountsAFailureAsTheRulesSay) {
  TuneOrder order = order_of(1);
  Rules rules;
  rules.budget = 15;
  order.race.world = steps_world(rules);
  const Tune found = tune("flood", "stride", order);
  EXPECT_EQ(found.evaluations[0].failures, 1);
  EXPECT_DOUBLE_EQ(found.evaluations[0].by_maze[1].value(), 100.0);
}

TEST(Tune, DoesNotDependOnTheNumberOfThreads) {
  TuneOrder order = order_of(16);
  order.race.jobs = 1;
  const std::string alone = csv_of(tune("visit-counter", both, order));
  for (const int jobs : {0, 2, 5}) {
    order.race.jobs = jobs;
    EXPECT_EQ(csv_of(tune("visit-counter", both, order)), alone) << jobs;
  }
  order.race.seed = 2;
  EXPECT_NE(csv_of(tune("visit-counter", both, order)), alone);
}

TEST(Tune, KeepsWhatWasDoneBeforeItWasStopped) {
  std::atomic<bool> stop = false;
  int contests = 0, generations = 0;
  TuneHooks hooks;
  hooks.stop = &stop;
  // The mouse as given has nine contests, and so has each candidate: it is stopped in the third of the first
  // generation.
  hooks.finished = [&](std::size_t) { stop = ++contests == 9 + 9 + 9 + 1; };
  hooks.generation = [&](const Tune&) { ++generations; };
  TuneOrder order = order_of(30);
  order.race.jobs = 1;
  const Tune found = tune("visit-counter", both, order, hooks);
  EXPECT_TRUE(found.stopped);
  EXPECT_EQ(generations, 2);
  EXPECT_EQ(found.evaluations.size(), 3U);
  const Tune whole = tune("visit-counter", both, order);
  for (std::size_t i = 1; i < 3; ++i)
    EXPECT_TRUE(
        std::any_of(whole.evaluations.begin() + 1, whole.evaluations.begin() + 6, [&](const Evaluation& evaluation) {
          return evaluation.mouse == found.evaluations[i].mouse && evaluation.value == found.evaluations[i].value;
        }));
  EXPECT_THAT(table_of(found, false), Says("Stopped", "3 of 30 evaluations"));
}

TEST(Tune, StoppedAtOnceHasNothing) {
  const std::atomic<bool> stop = true;
  TuneHooks hooks;
  hooks.stop = &stop;
  const Tune found = tune("flood", "stride", order_of(9), hooks);
  EXPECT_TRUE(found.stopped);
  EXPECT_THAT(found.evaluations, IsEmpty());
  EXPECT_THAT(table_of(found, false), Says("Stopped", "0 of 9 evaluations"));
  EXPECT_EQ(XmlScanner(picture_of(found)).complaint(), "");
}

TEST(Tune, RacesNothingWhereNothingCanBeTuned) {
  const auto ranges = read_ranges("flood", "stride").ranges;
  EXPECT_THAT(hold_tune("flood", ranges, {test::without_route()}, order_of(5)).error, Says("goal", "tune"));
  EXPECT_THAT(hold_tune("flod", ranges, mazes(), order_of(5)).error, Says("'flod'", "'flood'"));
  EXPECT_THAT(hold_tune("flood", {}, mazes(), order_of(5)).error, HasSubstr("no parameter"));
}

/// Made up: the best is the third.
Tune made_up() {
  Tune tune;
  tune.order = order_of(4);
  tune.ranges = read_ranges("visit-counter", both).ranges;
  tune.mazes = 3;
  tune.evaluations = {{0, 0.0, "visit-counter", {"0.2", "0.8333"}, 30.0, 1, {30.0, 20.0, 40.0}},
                      {1, 0.2, "visit-counter:random_share=0.3", {"0.3", "0.8333"}, 32.0, 2, {30.0, 26.0, 40.0}},
                      {1, 0.2, "visit-counter:random_share=0.1", {"0.1", "0.8333"}, 28.0, 0, {25.0, 21.0, 38.0}},
                      {2, 0.15, "visit-counter:random_share=0.4", {"0.4", "0.8333"}, 29.5, 0, {30.0, 20.5, 38.0}}};
  return tune;
}

TEST(Tune, GainsNothingByFailing) {  // where failed contests have no score, and candidates fail in different mazes
  TuneOrder order = order_of(5);
  order.race.world = find_world("physical")->make({{"variation", "2.5"}}).world;
  order.race.runs = 3;
  const RangesResult ranges = read_ranges("festina", "search,slower,step");
  const Tune found = hold_tune("festina", ranges.ranges, mazes(), order);
  ASSERT_EQ(found.evaluations.size(), 5U);
  const double limit = order.race.world->traits().limit_score;
  int failed = 0;
  for (const Evaluation& evaluation : found.evaluations) {
    failed += evaluation.failures;
    ASSERT_EQ(evaluation.by_maze.size(), 3U);
    EXPECT_GE(evaluation.value, limit * evaluation.failures / 6.0);  // three runs in each of two mazes with a route
    EXPECT_GE(evaluation.value, best_of(found).value);
    EXPECT_GT(evaluation.value, 0.0);
  }
  EXPECT_GT(failed, 0);
  EXPECT_THAT(table_of(found, false), HasSubstr("as given"));
}

TEST(Gain, PairsTheSameMazes) {
  Tune tune = made_up();
  tune.evaluations[0].by_maze = {30.0, std::nullopt, 40.0};
  const Gain gain = gain_of(tune);
  EXPECT_DOUBLE_EQ(gain.mean, -3.5);  // of -5 and -2
  tune.evaluations[2].by_maze = {std::nullopt, 1.0, std::nullopt};
  EXPECT_EQ(gain_of(tune).interval, std::nullopt);
}

TEST(Gain, IsThePairedDifference) {
  const Gain gain = gain_of(made_up());
  EXPECT_DOUBLE_EQ(gain.mean, -2.0);  // of -5, +1 and -2
  EXPECT_EQ(gain.better, 2);
  EXPECT_EQ(gain.equal, 0);
  EXPECT_EQ(gain.worse, 1);
  const std::vector<double> differences = {-5.0, 1.0, -2.0};
  EXPECT_EQ(gain.interval, mean_interval(differences, 1));
}

TEST(Gain, OfOneMazeHasNoInterval) {
  Tune tune = made_up();
  for (Evaluation& evaluation : tune.evaluations) evaluation.by_maze.resize(1);
  EXPECT_EQ(gain_of(tune).interval, std::nullopt);
}

TEST(TuneAsTable, ShowsGivenAndBestAndTheSpec) {
  const std::string table = table_of(made_up(), false);
  EXPECT_THAT(table, HasSubstr("\nparameter          low      high       given        best\n"
                               "random_share         0         1         0.2         0.1\n"
                               "coverage           0.2       0.9      0.8333      0.8333\n"));
  EXPECT_THAT(
      table,
      HasSubstr("as given   30.000, 1 contest failed\nbest       28.000, evaluation 3 of 4\ndifference -2.000 ["));
  EXPECT_THAT(table, Says("3 mazes", "2 better, 0 equal, 1 worse"));
  EXPECT_THAT(table, HasSubstr("`labmouse study`"));
  EXPECT_THAT(table, EndsWith("\n\nvisit-counter:random_share=0.1\n"));
  EXPECT_THAT(table, Not(HasSubstr("\x1b")));
  EXPECT_THAT(table_of(made_up(), true), HasSubstr("\x1b[1m"));
}

TEST(TuneAsTable, SaysWhereNothingIsBetter) {
  Tune tune = made_up();
  tune.evaluations.resize(2);
  const std::string table = table_of(tune, false);
  EXPECT_THAT(table, Says("No better", "2 evaluations"));
  EXPECT_THAT(table, Not(HasSubstr("difference")));
  EXPECT_THAT(table, Not(HasSubstr("`labmouse study`")));
  EXPECT_THAT(table, EndsWith("\nvisit-counter\n"));
}

TEST(TuneAsCsv, HasALineForEachEvaluation) {
  EXPECT_EQ(csv_of(made_up()),
            "evaluation,generation,step,score,failures,random_share,coverage,mouse\n"
            "1,0,0,30,1,0.2,0.8333,visit-counter\n"
            "2,1,0.2,32,2,0.3,0.8333,visit-counter:random_share=0.3\n"
            "3,1,0.2,28,0,0.1,0.8333,visit-counter:random_share=0.1\n"
            "4,2,0.15,29.5,0,0.4,0.8333,visit-counter:random_share=0.4\n");
  Tune tune = made_up();
  tune.order.objective = Objective::ratio;
  EXPECT_THAT(csv_of(tune), HasSubstr("step,ratio,failures"));
}

TEST(TuneAsPicture, ShowsMeanAndBestOfEachGeneration) {
  const std::string svg = picture_of(made_up());
  EXPECT_EQ(XmlScanner(svg).complaint(), "");
  EXPECT_EQ(count(svg, "<circle"), 3 + 2);  // as given and two generations, and two in the legend
  EXPECT_THAT(svg, HasSubstr("<title>as given: 30.000</title>"));
  EXPECT_THAT(svg, HasSubstr("<title>generation 1: mean 30.000, best 28.000</title>"));
  EXPECT_THAT(svg, HasSubstr("<title>generation 2: mean 29.500, best 29.500</title>"));
}

}  // namespace
}  // namespace labmouse
