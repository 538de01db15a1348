#include "labmouse/lab/races/tournament.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/races/contest_list.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "tests/lab/race_fixture.hpp"

namespace labmouse {
namespace {

/// A race's results without the times, the one thing that may differ.
std::string digest(const Race& race) {
  std::string text;
  for (const ContestResult& r : race.results)
    text += race.mice[r.mouse].name + ' ' + race.mazes[r.maze].name + ' ' + std::to_string(r.run) + ' ' +
            std::to_string(r.seed) + ' ' + std::string(name_of(r.score.outcome)) + ' ' +
            std::to_string(r.score.exploration_steps) + ' ' + std::to_string(r.score.speed_steps) + ' ' +
            std::string(name_of(r.reason)) + ' ' + std::to_string(r.decisions) + '\n';
  return text;
}

Standing standing_of(const Race& race, std::string_view mouse) {
  for (const Standing& standing : standings_of(race))
    if (race.mice[standing.mouse].name == mouse) return standing;
  ADD_FAILURE() << "no standing of " << mouse;
  return {};
}

TEST(Race, DoesNotDependOnTheNumberOfThreads) {
  RaceOrder order;
  order.jobs = 1;
  const std::string alone = digest(test::race_of("random,flood,certify", order));
  for (const int jobs : {0, 2, 7}) {
    order.jobs = jobs;
    EXPECT_EQ(digest(test::race_of("random,flood,certify", order)), alone) << jobs;
  }
}

TEST(Race, DoesNotDependOnTheOrderOfMiceOrMazes) {
  const Race one = hold_race(test::mice("random,flood"), {test::loop(), test::corridor()}, {});
  const Race other = hold_race(test::mice("flood,random"), {test::corridor(), test::loop()}, {});
  EXPECT_EQ(digest(one), digest(other));
}

TEST(Race, OfAMouseDoesNotDependOnTheOthers) {
  EXPECT_NE(digest(test::race_of("random,flood,certify")).find(digest(test::race_of("random"))), std::string::npos);
}

TEST(Race, GivesMiceThatThrowDiceSeveralRuns) {
  RaceOrder order;
  order.runs = 5;
  const Race race = hold_race(test::mice("random,flood"), {test::corridor()}, order);
  EXPECT_EQ(race.results.size(), 5U + 1U);
  EXPECT_EQ(standing_of(race, "random").runs, 5);
}

TEST(Race, SeedsDependOnRaceMazeAndRun) {
  EXPECT_NE(contest_seed(1, "a", 0), contest_seed(2, "a", 0));
  EXPECT_NE(contest_seed(1, "a", 0), contest_seed(1, "b", 0));
  EXPECT_NE(contest_seed(1, "a", 0), contest_seed(1, "a", 1));
}

TEST(Race, SeedsDoNotDependOnTheFolder) {
  EXPECT_EQ(contest_seed(1, "here/a.txt", 3), contest_seed(1, "/there/a.txt", 3));
}

TEST(Race, ASeedGivesAnotherRace) {
  RaceOrder order;
  order.seed = 2;
  EXPECT_NE(digest(test::race_of("random", order)), digest(test::race_of("random")));
}

TEST(Race, BeginsNoContestOnceItIsStopped) {
  std::atomic<bool> stop = false;
  int told = 0;
  RaceHooks hooks;
  hooks.stop = &stop;
  hooks.finished = [&](const Race&, const ContestResult&, const RunRecord&) {
    ++told;
    stop = true;
  };
  RaceOrder order;
  order.jobs = 1;
  const Race race = hold_race(test::mice("flood,certify"), {test::loop(), test::corridor()}, order, hooks);
  EXPECT_TRUE(race.stopped);
  EXPECT_EQ(told, 1);
  int done = 0;
  for (const ContestResult& result : race.results) done += result.done ? 1 : 0;
  EXPECT_EQ(done, 1);
}

TEST(Race, TellsOfEachContestWithItsRecord) {
  int told = 0;
  RaceHooks hooks;
  hooks.finished = [&](const Race&, const ContestResult& result, const RunRecord& record) {
    ++told;
    EXPECT_EQ(result.decisions, static_cast<int>(record.steps.size()));
  };
  EXPECT_FALSE(hold_race(test::mice("flood,random"), {test::loop(), test::corridor()}, {}, hooks).stopped);
  EXPECT_EQ(told, 2 + 40);
}

TEST(Standings, LeaveMazesWithoutARouteOut) {
  const Race race = test::race_of("flood");
  const Standing standing = standing_of(race, "flood");
  EXPECT_EQ(race.results.size(), 3U);
  EXPECT_EQ(standing.runs, 2);
  EXPECT_EQ(standing.solved, 2);
  EXPECT_EQ(standing.penalised_mean, standing.mean_score);
}

TEST(Standings, WithoutAnyRouteHaveNoMeans) {
  const Race race = hold_race(test::mice("flood"), {test::without_route()}, {});
  const Standing standing = standing_of(race, "flood");
  EXPECT_EQ(standing.runs, 0);
  EXPECT_EQ(standing.mean_score, std::nullopt);
  EXPECT_EQ(standing.penalised_mean, std::nullopt);
}

TEST(Standings, OfTheOracleAreTheBound) {
  const Standing standing = standing_of(test::race_of("oracle"), "oracle");
  EXPECT_DOUBLE_EQ(standing.mean_ratio.value(), 1.0);
  EXPECT_DOUBLE_EQ(standing.mean_speed_over_optimum.value(), 0.0);
  EXPECT_DOUBLE_EQ(standing.optimal_share, 1.0);
}

/// A race made up: two mice in two mazes, the second maze unsolved by the first mouse.
Race made_up() {
  Race race;
  race.mice = test::mice("certify,flood");
  race.mazes = {test::corridor(), test::loop()};
  race.bounds = {{3, 3.0}, {4, 8.0}};
  const auto add = [&](std::size_t mouse, std::size_t maze, Outcome outcome, int exploration, int speed,
                       std::optional<double> value) {
    ContestResult result;
    result.mouse = mouse;
    result.maze = maze;
    result.done = true;
    result.score = {outcome, exploration, speed, value};
    result.decisions = exploration + speed;
    result.microseconds = 2.0 * result.decisions;
    race.results.push_back(result);
  };
  add(0, 0, Outcome::solved, 30, 3, 4.0);
  add(0, 1, Outcome::out_of_steps, 1000, 0, {});
  add(1, 0, Outcome::solved, 60, 4, 6.0);
  add(1, 1, Outcome::solved, 120, 4, 8.0);
  return race;
}

TEST(Standings, CountAFailureAsAHundred) {
  const Standing standing = standing_of(made_up(), "certify");
  EXPECT_EQ(standing.solved, 1);
  EXPECT_DOUBLE_EQ(standing.mean_score.value(), 4.0);
  EXPECT_DOUBLE_EQ(standing.penalised_mean.value(), 52.0);
}

TEST(Standings, AreSortedByTheMeanOverAll) {
  const Race race = made_up();
  const auto standings = standings_of(race);
  EXPECT_EQ(race.mice[standings[0].mouse].name, "flood");
  EXPECT_EQ(race.mice[standings[1].mouse].name, "certify");
}

TEST(Standings, CountWhatTheTableShows) {
  const Standing standing = standing_of(made_up(), "flood");
  EXPECT_DOUBLE_EQ(standing.mean_ratio.value(), (6.0 / 3.0 + 8.0 / 8.0) / 2);
  EXPECT_DOUBLE_EQ(standing.mean_exploration.value(), 90.0);
  EXPECT_DOUBLE_EQ(standing.mean_speed_over_optimum.value(), 0.5);
  EXPECT_DOUBLE_EQ(standing.optimal_share, 0.5);
  EXPECT_DOUBLE_EQ(standing.microseconds_per_decision, 2.0);
}

TEST(Standings, TheShareOfOptimalRunsIsOfAllContests) {
  EXPECT_DOUBLE_EQ(standing_of(made_up(), "certify").optimal_share, 0.5);
}

TEST(Standings, TheIntervalHoldsTheMean) {
  const Standing standing = standing_of(made_up(), "flood");
  EXPECT_LE(standing.interval.low, 7.0);
  EXPECT_GE(standing.interval.high, 7.0);
}

TEST(Standings, ContestsThatWereNotHeldCountNothing) {
  Race race = made_up();
  race.results[1].done = false;
  EXPECT_DOUBLE_EQ(standing_of(race, "certify").penalised_mean.value(), 4.0);
}

}  // namespace
}  // namespace labmouse
