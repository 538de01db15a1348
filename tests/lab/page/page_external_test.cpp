// Programs that the page runs: their contests, and races in which they take part.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <sstream>

#include "labmouse/contest/simulator.hpp"
#include "tests/lab/page/page_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::answer;
using test::data_of;
using test::error_of;
using test::json;
using test::Says;

json beginning(const NamedMaze& maze, const std::string& name = "mine") {
  return {{"name", name}, {"spec", "program:node mouse.js"}, {"maze", data_of(maze)}, {"seed", 1}};
}

std::string answer_line(const Action& action) {
  return action.kind == Action::Kind::reset ? "reset\n" : fmt::format("move {} {}\n", action.rotation, action.movement);
}

/// A contest of a program that decides as a mouse of ours does; its end, as the page has it.
json held(const json& request, const NamedMaze& maze, const char* mouse = "flood", const std::string& printed = "") {
  json now = answer("program_begin", request);
  const auto strategy = test::mice(mouse).front().strategy(maze.maze, brief(maze.maze, {}, 1));
  now = answer("program_hear", {{"contest", now["contest"]}, {"output", "labmouse 1\n"}, {"printed", printed}});
  while (!now["ended"]) {
    std::istringstream words(now["lines"].back().get<std::string>());
    std::string sense;
    Sighting seen;
    words >> sense >> seen.left >> seen.ahead >> seen.right;
    now = answer("program_hear", {{"contest", now["contest"]}, {"output", answer_line(strategy->decide(seen))}});
  }
  return answer("program_end", {{"contest", now["contest"]}});
}

TEST(PageExternal, HasTheContestOfTheStrategyThatItIs) {
  for (const NamedMaze& maze : {test::loop(), test::corridor(), test::hook()}) {
    const json end = held(beginning(maze), maze, "flood", "a note\n");
    const json ours = answer("contest", {{"mouse", "flood"}, {"maze", data_of(maze)}, {"seed", 1}});
    for (const char* field : {"x", "y", "action", "known", "score", "outcome"})
      EXPECT_EQ(end["play"][field], ours["play"][field]) << field;
    EXPECT_EQ(end["play"]["mouse"], "mine");
    EXPECT_EQ(end["play"]["last_words"], "a note\n");
    EXPECT_EQ(end["started"], true);
    EXPECT_GT(end["microseconds"], 0.0);
    // The record is read again, and so is what it is packed to.
    EXPECT_EQ(answer("open", {{"name", "a"}}, end["record"].get<std::string>())["play"]["x"], ours["play"]["x"]);
    const json unpacked = answer("unpack", {{"record", end["packed"]}, {"maze", data_of(maze)}});
    EXPECT_EQ(unpacked["play"]["x"], end["play"]["x"]);
  }
}

TEST(PageExternal, ForfeitsAsItEnds) {
  const auto end = [](const json& how) {
    const json now = answer("program_begin", beginning(test::hook()));
    answer("program_hear", {{"contest", now["contest"]}, {"end", how}});
    return answer("program_end", {{"contest", now["contest"]}});
  };
  const json failed = end({{"kind", "failed"}, {"message", "x is not defined"}, {"line", 3}});
  EXPECT_EQ(failed["play"]["outcome"], "forfeit: ended early");
  EXPECT_EQ(failed["started"], false);
  EXPECT_THAT(failed["play"]["last_words"].get<std::string>(), Says("error", "line 3", "x is not defined"));
  EXPECT_EQ(end({{"kind", "exited"}, {"code", 0}})["play"]["outcome"], "forfeit: ended early");
  EXPECT_EQ(end({{"kind", "silent"}, {"seconds", 2}})["play"]["outcome"], "forfeit: hung");
  EXPECT_EQ(end({{"kind", "printed"}, {"what", "x"}})["play"]["outcome"], "forfeit: too much written");
  const json now = answer("program_begin", beginning(test::hook()));
  EXPECT_EQ(answer("program_end", {{"contest", now["contest"]}})["play"]["outcome"], "forfeit: interrupted");
}

TEST(PageExternal, RefusesNamesThatSayOtherThings) {
  for (const char* name : {"a b", "a=b", "a:b", "a/b", "flood", "oracle", "a\nb",
                           "a-name-that-is-longer-than-anybody-would-want-it-to-be"})
    EXPECT_NE(error_of("program_begin", beginning(test::hook(), name)), "") << name;
  const json unnamed = answer("program_begin", beginning(test::hook(), ""));
  EXPECT_EQ(answer("program_end", {{"contest", unnamed["contest"]}})["play"]["mouse"], "program:node mouse.js");
}

TEST(PageExternal, KnowsNoContestThatIsOver) {
  const json now = answer("program_begin", beginning(test::hook()));
  answer("program_end", {{"contest", now["contest"]}});
  EXPECT_THAT(error_of("program_hear", {{"contest", now["contest"]}}), Says("no such contest"));
}

const std::vector<NamedMaze>& racecourse() {
  static const std::vector<NamedMaze> mazes = {test::corridor(), test::hook(), test::loop()};
  return mazes;
}

/// A mouse that decides as another one does, in all mazes of the race.
json played_as(const char* mouse) {
  json contests = json::array();
  for (const NamedMaze& maze : racecourse()) {
    json request = beginning(maze);
    request["races"] = true;
    json end = held(request, maze, mouse);
    contests.push_back({{"record", end["record"]}, {"started", end["started"]}, {"microseconds", end["microseconds"]}});
  }
  return {{"name", "mine"}, {"spec", "program:node mouse.js"}, {"contests", contests}};
}

json race_with(const json& played) {
  json mazes = json::array();
  for (const NamedMaze& maze : racecourse()) mazes.push_back(data_of(maze));
  return {{"mice", {"flood", "certify"}}, {"mazes", mazes}, {"seed", 1}, {"runs", 1}, {"played", {played}}};
}

TEST(PageExternal, StandsWhereTheStrategyStandsThatItIs) {
  const json results = answer("race", race_with(played_as("flood")))["results"];
  ASSERT_EQ(results["groups"][0]["mice"].size(), 3U);
  const auto of = [&](const std::string& name) {
    for (const json& mouse : results["groups"][0]["mice"])
      if (mouse["name"] == name) return mouse;
    return json();
  };
  json mine = of("mine"), flood = of("flood");
  for (const char* field : {"finished", "runs", "mean_score", "mean_par1", "interval", "mean_ratio"})
    EXPECT_EQ(mine[field], flood[field]) << field;
  for (std::size_t i = 0; i < mine["results"].size(); ++i)
    for (const char* field : {"maze", "score", "search_steps", "speed_steps", "visited_share"})
      EXPECT_EQ(mine["results"][i][field], flood["results"][i][field]) << field;
  EXPECT_GT(mine["microseconds_per_decision"], 0.0);
}

TEST(PageExternal, RacesOnlyWithItsOwnContests) {
  const json whole = played_as("flood");
  const auto error = [](const json& played) { return error_of("race", race_with(played)); };
  json less = whole;
  less["contests"].erase(1);
  EXPECT_THAT(error(less), Says("mine", "no contest", "hook"));
  json other = whole;
  other["name"] = "yours";
  EXPECT_THAT(error(other), Says("yours", "not of this race"));
  json changed = whole;
  std::string record = changed["contests"][0]["record"];
  const std::string cell = "\"cell\":[0,0]";
  record.replace(record.find(cell), cell.size(), "\"cell\":[1,0]");
  changed["contests"][0]["record"] = record;
  EXPECT_NE(error(changed), "");
  json seeded = race_with(whole);
  seeded["seed"] = 2;
  EXPECT_THAT(error_of("race", seeded), Says("no contest"));
  json budget = race_with(whole);
  budget["budget"] = 500;
  EXPECT_THAT(error_of("race", budget), Says("not of this race"));
  json alone = race_with(whole);
  alone["mice"] = json::array();
  EXPECT_EQ(answer("race", alone)["results"]["groups"][0]["mice"].size(), 1U);
}

}  // namespace
}  // namespace labmouse
