#include "labmouse/lab/standings/baseline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>

#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "tests/lab/records/record_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::HasSubstr;
using ::testing::Not;

std::string compared(const Race& now, std::string_view earlier_json) {
  const auto read = read_baseline(earlier_json, now.world());
  EXPECT_EQ(read.error, "");
  return read.baseline ? compare_with_baseline(now, *read.baseline) : "";
}

/// What a race of the new mice says of an earlier one.
std::string compared(std::string_view now, std::string_view earlier) {
  return compared(test::race_of(now), json_of(test::race_of(earlier), {}));
}

TEST(Baseline, ItselfShowsNoDifference) {
  EXPECT_THAT(compared("flood", "flood"),
              Says("flood: +0.000 [+0.000, +0.000] ", "2 mazes", "0 better, 2 equal, 0 worse"));
}

TEST(Baseline, PairsMiceByTheirNames) {
  const std::string text = compared("flood,certify,random", "random,flood,certify");
  for (const char* mouse : {"flood: +0.000", "certify: +0.000", "random: +0.000"}) EXPECT_THAT(text, HasSubstr(mouse));
}

TEST(Baseline, TheOnlyMouseIsComparedWithTheOnlyMouse) {
  const std::string text = compared("oracle", "flood:stride=1");
  EXPECT_THAT(text, HasSubstr("oracle against flood:stride=1: -"));
  EXPECT_THAT(text, Says("2 better, 0 equal, 0 worse", ": too few mazes", "Add 6"));
}

TEST(Baseline, VariantsAreComparedWithTheOnlyMouse) {
  const std::string text = compared("flood:stride=1,flood:stride=2", "flood");
  EXPECT_THAT(text, HasSubstr("flood:stride=1 against flood: "));
  EXPECT_THAT(text, HasSubstr("flood:stride=2 against flood: "));
}

TEST(Baseline, MazesMayHaveMovedToAnotherFolder) {
  NamedMaze before = test::loop(), now = test::loop();
  before.name = "there/loop.txt";
  now.name = "here/loop.txt";
  const Race earlier = hold_race(test::mice("flood"), {before}, test::in_steps());
  EXPECT_THAT(compared(hold_race(test::mice("flood"), {now}, test::in_steps()), json_of(earlier, {})),
              HasSubstr("1 maze ("));
}

TEST(Baseline, AMouseThatWasNotThereIsSaidToBeNew) {
  EXPECT_THAT(compared("flood,certify", "flood,random"), HasSubstr("certify: not in"));
}

TEST(Baseline, AFailureCountsAsTheFailureScore) {
  const std::string earlier =
      R"({"labmouse":"x","mice":[{"name":"flood","results":[{"maze":"corridor","score":null},{"maze":"loop","score":null}]}]})";
  const std::string text = compared(test::race_of("flood"), earlier);
  EXPECT_THAT(text, HasSubstr("flood: -9"));
  EXPECT_THAT(text, HasSubstr("2 better"));
}

TEST(Baseline, MazesInCommonAreCompared) {
  const Race earlier = hold_race(test::mice("flood"), {test::loop()}, test::in_steps());
  EXPECT_THAT(compared(test::race_of("flood"), json_of(earlier, {})), HasSubstr("1 maze ("));
}

TEST(Baseline, OneMazeShowsNoDifference) {
  for (const char* mice : {"oracle", "flood:stride=1"}) {
    const Race earlier = hold_race(test::mice(mice), {test::loop()}, test::in_steps());
    const Race now = hold_race(test::mice("flood:stride=1,oracle"), {test::loop()}, test::in_steps());
    const std::string text = compared(now, json_of(earlier, {}));
    EXPECT_THAT(text, HasSubstr(" over 1 maze ("));
    EXPECT_THAT(text, Not(HasSubstr(": better\n")));
    EXPECT_THAT(text, Not(HasSubstr(": worse\n")));
  }
}

TEST(Baseline, WithoutACommonMazeItSaysSo) {
  NamedMaze other = test::loop();
  other.name = "another";
  const Race earlier = hold_race(test::mice("flood"), {other}, test::in_steps());
  EXPECT_THAT(compared(test::race_of("flood"), json_of(earlier, {})), HasSubstr("no mazes in common"));
}

constexpr std::string_view in_seconds =
    R"({"labmouse":"x","mice":[],"groups":[{"world":"seconds","mice":[{"name":"flood","results":[)"
    R"({"maze":"loop","score":null},{"maze":"loop","score":{"value":2500000}},{"maze":"hook","score":null}]}]}]})";

TEST(Baseline, AFailureWithoutAScoreCountsTheTimeLimit) {
  const auto world = default_world("seconds");
  const std::string json(in_seconds);
  const ReadBaselineResult read = read_baseline(json, *world);
  ASSERT_TRUE(read.baseline) << read.error;
  const MazeScores& loop = read.baseline->mice.at("flood").at("loop");
  EXPECT_EQ(loop.contests, 2);
  EXPECT_EQ(loop.finished, 1);
  EXPECT_DOUBLE_EQ(loop.mean().value(), (world->traits().limit_score + 2.5) / 2.0);
  EXPECT_DOUBLE_EQ(loop.finished_mean().value(), 2.5);
  EXPECT_EQ(read.baseline->mice.at("flood").at("hook").finished_mean(), std::nullopt);
  EXPECT_NE(read_baseline(test::changed(json, "2500000", "-2500000"), *world).error, "");
  EXPECT_NE(read_baseline(test::changed(json, "\"value\"", "\"other\""), *world).error, "");
}

/// A mouse in the failure model in so many mazes, of which it finished the first ones in those seconds.
Race finishing(int mazes, int finished, double seconds) {
  Race race;
  race.order.world = default_world("failures");
  race.mice = test::mice("flood");
  for (int maze = 0; maze < mazes; ++maze) {
    NamedMaze named = test::loop();
    named.name = "maze-" + std::to_string(maze);
    race.mazes.push_back(named);
    race.facts.push_back({1.0, {}, {}});
    ContestResult result;
    result.maze = static_cast<std::size_t>(maze);
    result.done = true;
    if (maze < finished) result.score = result.counted = seconds + maze;
    race.results.push_back(result);
  }
  return race;
}

TEST(Baseline, AMouseThatFinishesMoreIsBetterThoughItsFinishedRunsAreSlower) {
  const Race before = finishing(30, 10, 10.0), now = finishing(30, 28, 15.0);
  Baseline baseline;
  for (std::size_t maze = 0; maze < before.mazes.size(); ++maze)
    baseline.mice["flood"][before.mazes[maze].name] = maze_scores(before, 0)[maze];
  const std::string text = compare_with_baseline(now, baseline);
  EXPECT_THAT(text, ::testing::ContainsRegex("flood: -[0-9].*: better\n"));
  EXPECT_THAT(text, Says("28 of 30 contests", "10 of 30"));
  EXPECT_THAT(text, ::testing::ContainsRegex("percent \\+60.0 .*: better\n"));
  EXPECT_THAT(text, HasSubstr("only the contests that finished: +5.000"));
  EXPECT_THAT(text, Not(HasSubstr("worse\n")));
  EXPECT_THAT(text, Says("2 comparisons"));
}

TEST(Baseline, WhatIsNoRaceIsRefused) {
  for (const char* bad :
       {"", "no json", "[]", "{}", "null", "3", R"({"labmouse":"x"})", R"({"labmouse":"x","mice":3})",
        R"({"labmouse":"x","mice":[3]})", R"({"labmouse":"x","mice":[{"name":3,"results":[]}]})",
        R"({"labmouse":"x","mice":[{"name":"flood"}]})", R"({"labmouse":"x","mice":[{"name":"flood","results":[3]}]})",
        R"({"labmouse":"x","mice":[{"name":"flood","results":[{"maze":3,"score":1}]}]})",
        R"({"labmouse":"x","mice":[{"name":"flood","results":[{"maze":"loop"}]}]})",
        R"({"labmouse":"x","mice":[{"name":"flood","results":[{"maze":"loop","score":"1"}]}]})",
        R"({"labmouse":"x","mice":[{"name":"flood","results":[{"maze":"loop","score":1e308}]}]})",
        R"({"labmouse":"x","mice":[{"name":"flood","results":[{"maze":"loop","score":-1}]}]})"})
    EXPECT_THAT(read_baseline(bad, *steps_world()).error,
                testing::AnyOf(HasSubstr("JSON of a race"), HasSubstr("not valid JSON")))
        << bad;
}

}  // namespace
}  // namespace labmouse
