#include "labmouse/lab/standings/baseline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "tests/lab/record_fixture.hpp"
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
  EXPECT_THAT(text, Says("2 better, 0 equal, 0 worse", ": better"));
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

TEST(Baseline, AFailureThatCountsNothingIsLeftOut) {
  const auto world = default_world("seconds");
  const std::string json =
      R"({"labmouse":"x","mice":[],"groups":[{"world":"seconds","mice":[{"name":"flood","results":[)"
      R"({"maze":"loop","score":null},{"maze":"loop","score":{"value":2500000}},{"maze":"hook","score":null}]}]}]})";
  const ReadBaselineResult read = read_baseline(json, *world);
  ASSERT_TRUE(read.baseline) << read.error;
  EXPECT_EQ(read.baseline->mice.at("flood"), (std::map<std::string, std::vector<double>>{{"loop", {2.5}}}));
  EXPECT_NE(read_baseline(test::changed(json, "2500000", "-2500000"), *world).error, "");
  EXPECT_NE(read_baseline(test::changed(json, "\"value\"", "\"other\""), *world).error, "");
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
