#include "labmouse/lab/standings/baseline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/standings/race_report.hpp"
#include "tests/lab/race_fixture.hpp"

namespace labmouse {
namespace {

using ::testing::HasSubstr;

std::string compared(const Race& now, std::string_view earlier_json) {
  const auto baseline = read_baseline(earlier_json, Rules());
  EXPECT_TRUE(baseline.has_value());
  return baseline ? compare_with_baseline(now, *baseline) : "";
}

/// What a race of the new mice says of an earlier one.
std::string compared(std::string_view now, std::string_view earlier) {
  return compared(test::race_of(now), json_of(test::race_of(earlier), {}));
}

TEST(Baseline, ItselfShowsNoDifference) {
  EXPECT_THAT(compared("flood", "flood"),
              HasSubstr("flood: +0.000 [+0.000, +0.000] over 2 mazes (0 better, 2 equal, 0 worse)"));
}

TEST(Baseline, PairsMiceByTheirNames) {
  const std::string text = compared("flood,certify,random", "random,flood,certify");
  for (const char* mouse : {"flood: +0.000", "certify: +0.000", "random: +0.000"}) EXPECT_THAT(text, HasSubstr(mouse));
}

TEST(Baseline, TheOnlyMouseIsComparedWithTheOnlyMouse) {
  const std::string text = compared("oracle", "flood:stride=1");
  EXPECT_THAT(text, HasSubstr("oracle against flood:stride=1: -"));
  EXPECT_THAT(text, HasSubstr("2 better, 0 equal, 0 worse): better"));
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
  const Race earlier = hold_race(test::mice("flood"), {before}, {});
  EXPECT_THAT(compared(hold_race(test::mice("flood"), {now}, {}), json_of(earlier, {})), HasSubstr("over 1 maze ("));
}

TEST(Baseline, AMouseThatWasNotThereIsSaidToBeNew) {
  EXPECT_THAT(compared("flood,certify", "flood,random"), HasSubstr("certify: not in the baseline"));
}

TEST(Baseline, AFailureCountsAsTheFailureScore) {
  const std::string earlier =
      R"({"labmouse":"x","mice":[{"name":"flood","results":[{"maze":"corridor","score":null},{"maze":"loop","score":null}]}]})";
  const std::string text = compared(test::race_of("flood"), earlier);
  EXPECT_THAT(text, HasSubstr("flood: -9"));
  EXPECT_THAT(text, HasSubstr("2 better"));
}

TEST(Baseline, MazesInCommonAreCompared) {
  const Race earlier = hold_race(test::mice("flood"), {test::loop()}, {});
  EXPECT_THAT(compared(test::race_of("flood"), json_of(earlier, {})), HasSubstr("over 1 maze ("));
}

TEST(Baseline, WithoutACommonMazeItSaysSo) {
  NamedMaze other = test::loop();
  other.name = "another";
  const Race earlier = hold_race(test::mice("flood"), {other}, {});
  EXPECT_THAT(compared(test::race_of("flood"), json_of(earlier, {})), HasSubstr("no maze in common"));
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
    EXPECT_FALSE(read_baseline(bad, Rules()).has_value()) << bad;
}

}  // namespace
}  // namespace labmouse
