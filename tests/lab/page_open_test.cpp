// Files that are dropped on the page.
#include <gmock/gmock.h>

#include "labmouse/lab/page/json_problem.hpp"
#include "labmouse/lab/pictures/mms_picture.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "tests/lab/mms_record_fixture.hpp"
#include "tests/lab/page_fixture.hpp"
#include "tests/lab/record_fixture.hpp"

namespace labmouse {
namespace {

using test::changed;
using test::data_of;
using test::json;
using test::recorded;
using ::testing::HasSubstr;

json opened(std::string_view content, const char* name = "file") {
  return test::answer("open", {{"name", name}}, content);
}
json refused(std::string_view content, const char* name = "file") {
  return test::failure("open", {{"name", name}}, content);
}

json problem(int line, int column, const std::string& reason) {
  return {{"line", line}, {"column", column}, {"reason", reason}};
}

TEST(PageOpens, MazesOfEveryFormat) {
  const Maze maze = depth_first_generator.make({{16, 16}, 1, 0});
  for (const Format* format : all_formats()) {
    const json file = opened(*format->write(maze).content, "a maze.txt");
    EXPECT_EQ(file["kind"], "maze") << format->name;
    EXPECT_EQ(file["maze"], data_of({"a maze.txt", maze})) << format->name;
  }
}

TEST(PageOpens, NoMazeThatIsNone) {
  const json said = refused("o---o\n|   x\no---o\n", "bad.txt");
  EXPECT_EQ(said["error"], "bad.txt is not a readable maze");
  ASSERT_FALSE(said["problems"].empty());
  EXPECT_EQ(said["problems"][0]["line"], 2);
  EXPECT_EQ(said["problems"][0]["column"], 5);
  EXPECT_EQ(refused(" \n", "x")["error"], "x is empty");
  EXPECT_EQ(refused("", "x")["error"], "x is empty");
}

TEST(PageOpens, Records) {
  const RecordFile file = recorded("ariadne", test::loop(), 1, true);
  const json said = opened(write_record(file));
  EXPECT_EQ(said["kind"], "record");
  const json ran = test::answer("run", {{"mouse", "ariadne"}, {"maze", data_of(test::loop())}, {"seed", 1}});
  EXPECT_EQ(said["play"], ran["play"]);
}

TEST(PageOpens, RecordsThatBreakOff) {
  const std::string text = write_record(recorded("flood"));
  const json play = opened(text.substr(0, text.size() / 2))["play"];
  EXPECT_EQ(play["ended"], false);
  EXPECT_THAT(play["outcome"].get<std::string>(), HasSubstr("the record breaks off after step "));
  EXPECT_EQ(play["clock"].size(), play["action"].size() + 1);
}

constexpr const char* robot = R"({"labmouse":"record","format":1}
{"action":[90,1]}
{"action":[0,1]}
)";

TEST(PageOpens, RecordsWithoutAMazeInTheOneOfThePage) {
  EXPECT_EQ(refused(robot, "robot.jsonl")["error"],
            "robot.jsonl is a record without its maze: open the maze first, then the record again");
  const json play = test::answer("open", {{"name", "robot.jsonl"}, {"maze", data_of(test::hook())}}, robot)["play"];
  EXPECT_EQ(play["maze"], data_of(test::hook()));
  EXPECT_EQ(play["checked"], "checked in 2 steps: no readings");
  EXPECT_EQ(play["blocked"], json::parse("[false,true]"));
}

TEST(PageOpens, NoRecordThatIsNone) {
  const std::string good = write_record(recorded("flood"));
  const json said = refused(changed(good, "\"step\":2", "\"step\":3"), "walk.jsonl");
  EXPECT_EQ(said["error"], "walk.jsonl is not a readable record");
  EXPECT_EQ(said["problems"], json::array({problem(3, 1, "the line has step 3 where step 2 is due")}));
  EXPECT_EQ(refused("{\"labmouse\":\"record\",\"for")["problems"],
            json::array({problem(1, 1, "the line is not JSON")}));
  EXPECT_EQ(refused("{ \"labmouse\" : \"mms record\",\n")["problems"],
            json::array({problem(1, 1, "the line is not JSON")}));
}

TEST(PageOpens, NoRecordOfAnotherMaze) {
  const std::string good = write_record(recorded("flood"));
  const json said = refused(changed(good, "\"reading\":[0,4,", "\"reading\":[0,3,"), "walk.jsonl");
  EXPECT_EQ(said["error"], "walk.jsonl does not agree with its maze");
  EXPECT_EQ(said["problems"][0]["line"], 0);
  EXPECT_THAT(said["problems"][0]["reason"].get<std::string>(), HasSubstr("step 1: recorded at (0,0)"));
}

/// Each number can be seen in the plank: two moves, of which the first enters the goal.
TEST(PageOpens, RecordsOfMms) {
  json play = opened(test::mms_recorded({"setColor 0 0 G", "turnRight", "setText 1 0 here it is", "moveForward 5",
                                         "setWall 2 0 e", "clearColor 0 0", "clearAllText", "ackReset", "setWall 0 0 n",
                                         "clearWall 0 0 n", "clearAllColor"}))["play"];
  for (const char* list : {"clock", "scores"}) {
    EXPECT_EQ(play[list].size(), 4U) << list;
    EXPECT_EQ(play[list][0], list == std::string("scores") ? 2000 : 0);
    play.erase(list);
  }
  EXPECT_EQ(play["counts"].size(), 12U);
  EXPECT_EQ(play["counts"][1], json::parse(R"({"name":"total-effective-distance","value":6})"));
  EXPECT_EQ(play["counts"][9]["value"], play["score"]);
  for (const char* field : {"counts", "score", "bound", "optimum"}) play.erase(field);
  json expected = json::parse(R"({
    "world": "mms", "mouse": "mms:./mouse", "rules": null, "seed": null, "outcome": "complete: exit code 0", "solved": false,
    "exploration_steps": 3, "speed_steps": 0, "discovered": null, "visited": null, "last_words": "",
    "checked": "", "ended": true, "x": [1, 1, 5, 1], "y": [1, 1, 1, 1], "heading": [0, 2, 2, 0], "run": [0, 0, 0, 0],
    "action": ["turnRight", "moveForward 5", "ackReset"], "blocked": [false, true, false],
    "left": [], "ahead": [], "right": [], "known": [], "goal_frame": null, "reset_frame": 3, "entered": [[], [1, 2], []],
    "route": [[0, 0], [1, 0]], "distances": [1, 0, 1], "reasons": [],
    "events": [
      {"frame": 0, "kind": "colour", "cell": [0, 0], "colour": "G"},
      {"frame": 1, "kind": "text", "cell": [1, 0], "text": "here it is"},
      {"frame": 2, "kind": "wall", "cell": [2, 0], "side": "east", "there": true},
      {"frame": 2, "kind": "colour", "cell": [0, 0], "colour": ""},
      {"frame": 2, "kind": "clear texts"},
      {"frame": 3, "kind": "wall", "cell": [0, 0], "side": "north", "there": true},
      {"frame": 3, "kind": "wall", "cell": [0, 0], "side": "north", "there": false},
      {"frame": 3, "kind": "clear colours"}]
  })");
  expected["maze"] = data_of({"plank", as_in_mms(test::plank().maze)});
  EXPECT_EQ(play, expected);
}

TEST(PageOpens, RecordsOfMmsWithDiagonals) {
  const NamedMaze maze = {"room", test::drawn("o---o---o\n|       |\no   o   o\n|       |\no---o---o")};
  const json play = opened(
      test::mms_recorded({"moveForwardHalf 1", "turnRight45", "moveForwardHalf 1", "turnRight45", "moveForwardHalf 1"},
                         most_recorded_events, maze))["play"];
  EXPECT_EQ(play["entered"], json::parse("[[],[],[2],[],[3]]"));
  EXPECT_EQ(play["heading"], json::parse("[0,0,1,1,2,2]"));
  EXPECT_EQ(play["goal_frame"], 1);
}

TEST(PageOpens, NoRecordOfMmsThatDoesNotFit) {
  const std::string good = test::mms_recorded({"turnRight", "moveForward"});
  const json said = refused(changed(good, "[3,1]", "[5,1]"), "mms.jsonl");
  EXPECT_EQ(said["error"], "mms.jsonl does not agree with its maze");
  EXPECT_THAT(said["problems"][0]["reason"].get<std::string>(), HasSubstr("event 2: recorded ack at [5,1]"));
  EXPECT_EQ(refused(changed(good, "\"place\":[3,1]", "\"place\":[3]"))["problems"],
            json::array({problem(3, 1, "the line has a place that is not [x, y]")}));
}

TEST(PageOpens, Pages) {
  EXPECT_EQ(refused("<!DOCTYPE html>\n<html><title>labmouse</title>", "report.html")["error"],
            "report.html is a page of labmouse: open it by itself, as any page");
  EXPECT_THAT(refused("\xEF\xBB\xBF <html>", "x.html")["error"].get<std::string>(),
              HasSubstr("x.html is a page or a picture; here go "));
  EXPECT_THAT(refused("<svg>labmouse</svg>", "x.svg")["error"].get<std::string>(),
              HasSubstr("x.svg is a page or a picture; here go "));
}

json results() {
  const Race race = test::race_of("flood,random", {steps_world(), 2, 7, 1});
  return json::parse(json_of(race, {{"bad.txt", {{1, 2, "no maze"}}}}));
}

TEST(PageOpens, Results) {
  const std::string text = results().dump(1);
  EXPECT_EQ(opened(text)["kind"], "results");
  EXPECT_EQ(opened(text)["results"], json::parse(text));
}

TEST(PageOpens, ResultsWithoutFieldsThatItDoesNotKnow) {
  json more = results();
  const json known = more;
  more["mice"][0]["results"][0]["extra"] = more["extra"] = 1;
  EXPECT_EQ(opened(more.dump())["results"], known);
}

TEST(PageOpens, ResultsOfAnotherWorldWithWhatIsPlainInThem) {
  json whole = results();
  whole["groups"] = json::parse(R"([{"world": "toy", "formula": "f", "robot": {"name": "r", "deep": {"a": 1}},
    "mazes": [{"name": "m", "width": 3, "height": 3, "least": 2.5}],
    "mice": [{"name": "a", "runs": 1, "mean_score": 4, "interval": [3, 5], "mean_ratio": 1.6, "odd": true,
      "results": [{"maze": "m", "outcome": "home", "score": {"value": 4, "parts": [1]}, "errors": ["e"], "list": [1]}]}]}])");
  json expected = whole["groups"];
  expected[0]["robot"].erase("deep");
  expected[0]["mice"][0]["results"][0]["score"].erase("parts");
  expected[0]["mice"][0]["results"][0].erase("list");
  EXPECT_EQ(opened(whole.dump())["results"]["groups"], expected);
  const auto reason = [&](const char* field, const json& value) -> std::string {
    return refused(test::with(whole, json::json_pointer(field), value).dump())["problems"][0]["reason"];
  };
  EXPECT_EQ(reason("/groups/0/world", 3), "'groups[0].world' is not a text");
  EXPECT_EQ(reason("/groups/0/mice/0/runs", "x"), "'groups[0].mice[0].runs' is not a whole number");
  EXPECT_EQ(reason("/groups/0/mice/0/interval", {3}), "'groups[0].mice[0].interval' is not [low, high]");
  EXPECT_EQ(reason("/groups/0/mice/0/results/0/outcome", nullptr),
            "'groups[0].mice[0].results[0].outcome' is not a text");
}

TEST(PageOpens, ResultsOfMms) {
  std::vector<Race> races = {test::race_of("flood"), test::imagined_race({"mms:a"}, {test::plank()})};
  test::imagine(races[1], 0, 0, test::imagined_run(4, 1, 10, 2));
  json whole = json::parse(json_of(races, {}));
  const json group = opened(whole.dump())["results"]["groups"][0];
  EXPECT_EQ(group["world"], "mms");
  EXPECT_EQ(group["mazes"], whole["groups"][0]["mazes"]);
  EXPECT_EQ(group["mice"][0]["results"][0]["score"], whole["groups"][0]["mice"][0]["results"][0]["score"]);
  whole["groups"][0]["mice"][0]["results"][0]["maze"] = "other";
  EXPECT_EQ(refused(whole.dump())["problems"][0]["reason"],
            "'groups[0].mice[0].results[0].maze' is not one of the race's mazes");
}

json refused_with(const char* field, const json& value) {
  json bad = results();
  bad[json::json_pointer(field)] = value;
  return refused(bad.dump(), "race.json");
}

TEST(PageOpens, NothingThatIsTooDeepToBeOurs) {
  const json said = refused(std::string(40, '[') + std::string(40, ']'));
  EXPECT_EQ(said["error"], "file is JSON, but has more lists and objects in each other than any of ours");
  EXPECT_EQ(refused(std::string(1'000'000, '['))["error"], said["error"]);
  EXPECT_EQ(refused("[\"" + std::string(40, '[') + "\\\"[\"]")["error"],
            "file is JSON, but neither a record nor the results of a race");
}

TEST(PageOpens, NoResultsWithWrongFields) {
  const auto reason = [](const char* field, const json& value) -> std::string {
    return refused_with(field, value)["problems"][0]["reason"];
  };
  EXPECT_EQ(refused_with("/seed", -1)["error"], "race.json has results of a race that cannot be read");
  EXPECT_EQ(reason("/seed", -1), "'seed' is not a number from 0 to 2^64 - 1");
  EXPECT_EQ(reason("/mice", 3), "'mice' is not a list");
  EXPECT_EQ(reason("/mice/1/name", 3), "'mice[1].name' is not a text");
  EXPECT_EQ(reason("/mice/0/interval", {1}), "'mice[0].interval' is not [low, high]");
  EXPECT_EQ(reason("/mice/0/parameters/stride", {1}), "'mice[0].parameters' has a wrong value of 'stride'");
  EXPECT_EQ(reason("/mice/1/results/2/score", "low"), "'mice[1].results[2].score' is not a number");
  EXPECT_EQ(reason("/mice/1/results/2/maze", "other"), "'mice[1].results[2].maze' is not one of the race's mazes");
  EXPECT_EQ(reason("/mice/1/results/2", 3), "'mice[1].results[2]' is not an object");
  EXPECT_EQ(reason("/mazes/0/width", 1.5), "'mazes[0].width' is not a whole number");
  EXPECT_EQ(reason("/skipped/0/reasons", {1}), "'skipped[0].reasons[0]' is not a text");
  EXPECT_EQ(reason("/groups", {3}), "'groups[0]' is not an object");
}

TEST(PageOpens, ResultsOfAnEarlierVersionWhereTheyHaveWhatIsNeeded) {
  json old = results();
  old["labmouse"] = "0.0.1";
  old["mice"][0].erase("mean_visited_share");
  EXPECT_TRUE(opened(old.dump())["results"]["mice"][0]["mean_visited_share"].is_null());
  old["mice"][0].erase("optimal_share");
  const json said = refused(old.dump(), "old.json");
  EXPECT_EQ(said["error"],
            "old.json has results of a race that cannot be read; labmouse 0.0.1 wrote them, and this is " +
                std::string(version()));
  EXPECT_EQ(said["problems"], json::array({problem(0, 0, "'mice[0].optimal_share' is missing")}));
}

TEST(PageOpens, NoJsonThatIsNone) {
  const json said = refused("{\n  \"mice\": [1,\n  }\n", "race.json");
  EXPECT_EQ(said["error"], "race.json is not readable JSON");
  ASSERT_EQ(said["problems"].size(), 1U);
  EXPECT_EQ(said["problems"][0]["line"], 3);
  EXPECT_EQ(said["problems"][0]["column"], 3);
  EXPECT_THAT(said["problems"][0]["reason"].get<std::string>(),
              HasSubstr("no JSON: syntax error while parsing value - unexpected '}'"));
  EXPECT_EQ(refused("[1]", "x")["error"], "x is JSON, but neither a record nor the results of a race");
}

TEST(JsonProblem, HasItsPlace) {
  const auto place = [](std::string_view text) {
    const Problem at = json_problem(text);
    return std::pair(at.line, at.column);
  };
  EXPECT_EQ(place("{,"), std::pair(1, 2));
  EXPECT_EQ(place("\n\n  x"), std::pair(3, 3));
  EXPECT_EQ(place("[1e999]"), std::pair(1, 6));
  EXPECT_EQ(place("[\n"), std::pair(2, 1));
  EXPECT_EQ(place(""), std::pair(1, 1));
  EXPECT_EQ(json_problem("[1e999]").reason, "no JSON: number overflow parsing '1e999'");
}

}  // namespace
}  // namespace labmouse
