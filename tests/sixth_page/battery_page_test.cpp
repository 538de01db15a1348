// The core of the page with that world in its list: the page itself asks for worlds, contests and races by what `about`
// says, and its own tests show it a world that it does not know.
#include <gtest/gtest.h>

#include "tests/lab/page/page_fixture.hpp"

namespace labmouse {
namespace {

using test::answer;
using test::json;

json request(const char* mice, const json& value) {
  return {{"world", "battery"}, {mice, value}, {"seed", 1}, {"robot", "half"}, {"noise", 1}};
}

TEST(ASixthWorldInThePage, IsOfferedRunAndRaced) {
  const json offered = answer("about", json::object())["worlds"].back();
  EXPECT_EQ(offered["name"], "battery");
  EXPECT_EQ(offered["plays"], true);
  EXPECT_EQ(offered["settings"].size(), 2U);

  const json maze = answer("builtin_maze", {{"name", "contest-01"}})["maze"];
  json contest = request("mouse", "flood");
  contest["maze"] = maze;
  const json held = answer("contest", contest);
  json again = held["play"]["again"]["with"];
  again.update({{"mouse", "flood"}, {"maze", maze}, {"seed", 1}});
  EXPECT_EQ(answer("contest", again), held);
  EXPECT_EQ(answer("open", {{"name", "a.jsonl"}}, held["record"].get<std::string>())["play"]["score"],
            held["play"]["score"]);

  // Without what else the world depends on, no other mouse can run there.
  const json opened = answer("open", {{"name", "a.jsonl"}}, held["record"].get<std::string>())["play"];
  EXPECT_EQ(opened["world"], "battery");
  EXPECT_FALSE(opened.contains("again"));

  json race = request("mice", {"flood"});
  race.update({{"mazes", {maze}}, {"runs", 3}});
  const json results = answer("race", race)["results"];
  EXPECT_EQ(results["groups"][0]["world"], "battery");
  EXPECT_EQ(results["groups"][0]["mice"][0]["results"].size(), 3U);
  EXPECT_EQ(answer("open", {{"name", "race.json"}}, results.dump())["results"]["groups"][0]["mice"],
            results["groups"][0]["mice"]);
}

}  // namespace
}  // namespace labmouse
