// One contest in the physical and in the failure model, as the page holds and plays it.
#include <gmock/gmock.h>

#include "labmouse/lab/mazes/builtin_mazes.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "tests/lab/drive/physical_fixture.hpp"
#include "tests/lab/page/page_fixture.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::answer;
using test::data_of;
using test::error_of;
using test::failure;
using test::json;
using ::testing::HasSubstr;

json asked(const std::string& world, std::uint64_t seed = 1, const std::string& noise = "1") {
  return {{"world", world},
          {"mouse", "flood-return"},
          {"maze", data_of({"ring", test::ring()})},
          {"seed", seed},
          {"noise", noise}};
}

TEST(PageContest, IsTheOneOfARace) {
  LABMOUSE_SKIP_SANITIZED();
  for (const std::string world : {"physical", "failures"}) {
    json race = asked(world, 5, "3");
    race["mice"] = json::array({"flood-return"});
    race["mazes"] = json::array({race["maze"]});
    race["runs"] = 2;
    const json group = answer("race", race)["results"]["groups"][0];
    ASSERT_EQ(group["mice"][0]["results"].size(), 2);
    for (const json& result : group["mice"][0]["results"]) {
      json contest = asked(world, result["seed"], "3");
      const json held = answer("contest", contest);
      EXPECT_EQ(held["play"]["outcome"], result["outcome"]);
      // By the conditions that the results tell as well.
      contest["conditions"] = group;
      contest["conditions"].erase("mice");
      contest.erase("noise");
      EXPECT_EQ(answer("contest", contest)["record"], held["record"]) << world;
    }
  }
}

TEST(PageContest, HasTheRulesOfTheMazesSize) {
  LABMOUSE_SKIP_SANITIZED();
  const auto rules_in = [](Size size, const json& rules) {
    json asked = {{"world", "seconds"}, {"robot", "half"}, {"mouse", "flood"}, {"seed", 1}};
    if (!rules.is_null()) asked["rules"] = rules;
    asked["maze"] = data_of({"any", depth_first_generator.make({.size = size})});
    const json contest = answer("contest", asked);
    json race = asked;
    race["mice"] = json::array({"flood"});
    race["mazes"] = json::array({asked["maze"]});
    race["runs"] = 1;
    EXPECT_EQ(answer("race", race)["results"]["groups"][0]["rules"]["name"], contest["play"]["drive"]["rules"]["name"]);
    return contest["play"]["drive"]["rules"]["name"];
  };
  for (const json& by_size : {json(), json("by-size")}) {
    EXPECT_EQ(rules_in({16, 16}, by_size), "all-japan");
    EXPECT_EQ(rules_in({20, 20}, by_size), "all-japan-half");
  }
  EXPECT_EQ(rules_in({20, 20}, "apec"), "apec");
}

TEST(PageContest, PlaysAsItsRecordDoes) {
  const json held = answer("contest", asked("physical", 3, "3"));
  const std::string record = held["record"];
  json opened = answer("open", {{"name", "a.jsonl"}}, record)["play"], play = held["play"];
  EXPECT_TRUE(play["drive"].contains("bodies"));
  EXPECT_EQ(play, opened);
}

TEST(PageContest, IsHeldAgainByAnotherMouse) {
  const json again = answer("contest", asked("physical", 3, "3"))["play"]["again"];
  json request = again["with"];
  EXPECT_EQ(request["world"], "physical");
  EXPECT_EQ(request["conditions"]["noise"], 3.0);
  request.update({{"mouse", "certify"}, {"maze", data_of({"ring", test::ring()})}, {"seed", 3}});
  EXPECT_EQ(answer("contest", request)["play"]["mouse"], "certify");
}

TEST(PageContest, SaysWhatIsWrong) {
  json contest = asked("physical");
  contest["noise"] = "loud";
  EXPECT_THAT(error_of("contest", contest), HasSubstr("noise"));
  contest = asked("nowhere");
  EXPECT_THAT(error_of("contest", contest), HasSubstr("nowhere"));
  contest = asked("mms");
  EXPECT_THAT(error_of("contest", contest), HasSubstr("mms"));
  contest = asked("physical");
  contest["mouse"] = "random-walk";
  EXPECT_FALSE(error_of("contest", contest).empty());
  contest = asked("physical");
  contest["conditions"] = {{"noise", 1}};
  EXPECT_THAT(error_of("contest", contest), HasSubstr("conditions"));
}

/// The contest that the page offers: the mouse reads a wall where there is none, and finds out.
TEST(PageContest, ShowsWhereBeliefAndTruthPartAndMeetAgain) {
  json contest = asked("physical", 8307636485000989);
  for (const BuiltinMaze& maze : builtin_mazes())
    if (maze.name == "contest-01") contest["maze"] = data_of({"contest-01", *read_maze(maze.text).maze});
  contest["mouse"] = "festina";
  const json play = answer("contest", contest)["play"];
  EXPECT_TRUE(play["finished"]);
  ASSERT_FALSE(play["mistaken"].empty());
  const json& first = play["mistaken"][0];
  EXPECT_TRUE(first["closed"]);
  const auto at = [&](const char* end) { return play["clock"][first[end].get<std::size_t>()].get<double>(); };
  EXPECT_NEAR(at("to") - at("from"), 4.6, 0.5);
  EXPECT_EQ(first["from"], play["known"][first["wall"].get<std::size_t>()]);
  // It crashes, and comes to the goal afterwards.
  const json& runs = play["drive"]["runs"];
  EXPECT_GT(std::count_if(runs.begin(), runs.end(), [](const json& run) { return !run["score"].is_null(); }), 1);
  EXPECT_FALSE(play["drive"]["bodies"]["touches"].empty());
}

/// Slow runs, and such that break off, have their frames and their path within their times.
TEST(PageContest, IsOnItsClock) {
  LABMOUSE_SKIP_SANITIZED();
  int slow = 0, broken = 0;
  for (const std::string world : {"physical", "failures"})
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      json contest = asked(world, seed, "3");
      contest["mouse"] = "festina";
      contest["pace"] = "0.9";
      const json play = answer("contest", contest)["play"];
      const json &runs = play["drive"]["runs"], &clock = play["clock"], &path = play["drive"]["path"];
      ASSERT_TRUE(std::is_sorted(clock.begin(), clock.end())) << world << seed;
      for (std::size_t i = 0; i < runs.size(); ++i) {
        const json& run = runs[i];
        const std::size_t last = i + 1 < runs.size() ? runs[i + 1]["frame"].get<std::size_t>() : clock.size() - 1;
        const double end = run["end"].get<double>() / 1e6;
        if (run["kind"] == "speed") {
          // The next run may begin with being carried to the start.
          const double told = clock[last].get<double>(), before = clock[last - 1].get<double>();
          EXPECT_TRUE(std::abs(told - end) < 2e-6 || std::abs(before - end) < 2e-6) << world << seed;
          slow += run["gate_in"].is_null() ? 0 : 1;
          broken += run["gate_in"].is_null() ? 1 : 0;
        }
        if (run["to"] == run["from"]) continue;
        EXPECT_LE(path["t"][run["to"].get<std::size_t>() - 1].get<double>(), run["end"].get<double>() + 1.0);
      }
    }
  EXPECT_GT(slow, 0);
  EXPECT_GT(broken, 0);
}

TEST(PageContest, TellsNoMistakesOfAMouseThatNeverErrs) {
  EXPECT_EQ(answer("contest", asked("physical", 1, "0"))["play"]["mistaken"], json::array());
  const json seconds = answer("contest", {{"world", "seconds"},
                                          {"mouse", "flood"},
                                          {"maze", data_of({"ring", test::ring()})},
                                          {"seed", 1},
                                          {"robot", "kerise"},
                                          {"rules", "all-japan"}});
  EXPECT_FALSE(seconds["play"].contains("mistaken"));
}

}  // namespace
}  // namespace labmouse
