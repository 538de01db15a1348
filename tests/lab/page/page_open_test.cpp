// Files that are dropped on the page.
#include <gmock/gmock.h>

#include "labmouse/lab/pictures/mms_picture.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/json_problem.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "tests/lab/page/page_fixture.hpp"
#include "tests/lab/records/mms_record_fixture.hpp"
#include "tests/lab/records/record_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::changed;
using test::data_of;
using test::json;
using test::recorded;
using test::Says;
using test::SaysAt;
using ::testing::HasSubstr;

json opened(std::string_view content, const char* name = "file") {
  return test::answer("open", {{"name", name}}, content);
}
json refused(std::string_view content, const char* name = "file") {
  return test::failure("open", {{"name", name}}, content);
}

std::string error_in(const json& said) { return said["error"]; }

/// One problem is said to be there, whose reason has these parts.
template <typename... Parts>
void expect_problem(const json& said, int line, int column, Parts... parts) {
  ASSERT_EQ(said["problems"].size(), 1U) << said;
  const json& problem = said["problems"][0];
  EXPECT_EQ(problem["line"], line);
  EXPECT_EQ(problem["column"], column);
  EXPECT_THAT(problem["reason"].get<std::string>(), Says(parts...));
}

TEST(PageOpens, MazesOfEveryFormat) {
  const Maze maze = depth_first_generator.make({{16, 16}, 1, 0});
  for (const Format* format : all_formats()) {
    const json file = opened(*format->write(maze).content, "a maze.txt");
    EXPECT_EQ(file["kind"], "maze") << format->name;
    EXPECT_EQ(file["maze"], data_of({"a maze.txt", maze})) << format->name;
  }
}

TEST(PageOpens, MazesWithNotesOnHowTheyWereRead) {
  const json file = opened("o---o---o\n| G   G  \no   o   o\n| G : G |\no---o---o\n", "a maze.txt");
  EXPECT_EQ(file["kind"], "maze");
  ASSERT_EQ(file["notes"].size(), 2U) << file;
  EXPECT_THAT(file["notes"][0].get<std::string>(), Says("1 of 4", "closed"));
  EXPECT_THAT(file["notes"][1].get<std::string>(), Says("east of (1,1)"));
}

TEST(PageOpens, NoMazeThatIsNone) {
  const json said = refused("o---o\n|   x\no---o\n", "bad.txt");
  EXPECT_THAT(error_in(said), Says("bad.txt ", "maze"));
  ASSERT_FALSE(said["problems"].empty());
  EXPECT_EQ(said["problems"][0]["line"], 2);
  EXPECT_EQ(said["problems"][0]["column"], 5);
  EXPECT_THAT(error_in(refused(" \n", "x")), Says("x ", "empty"));
  EXPECT_THAT(error_in(refused("", "x")), Says("x ", "empty"));
}

TEST(PageOpens, Records) {
  const RecordFile file = recorded("ariadne", test::loop(), 1, true);
  const json said = opened(write_record(file));
  EXPECT_EQ(said["kind"], "record");
  const json ran = test::answer("contest", {{"mouse", "ariadne"}, {"maze", data_of(test::loop())}, {"seed", 1}});
  EXPECT_EQ(said["play"], ran["play"]);
}

TEST(PageOpens, RecordsThatBreakOff) {
  const std::string text = write_record(recorded("flood"));
  const json play = opened(text.substr(0, text.size() / 2))["play"];
  EXPECT_EQ(play["ended"], false);
  EXPECT_THAT(play["outcome"].get<std::string>(), HasSubstr("breaks off after step "));
  EXPECT_EQ(play["clock"].size(), play["action"].size() + 1);
}

constexpr const char* robot = R"({"labmouse":"record","format":1}
{"action":[90,1]}
{"action":[0,1]}
)";

TEST(PageOpens, RecordsWithoutAMazeInTheOneOfThePage) {
  EXPECT_THAT(error_in(refused(robot, "robot.jsonl")), Says("robot.jsonl ", "without its maze"));
  const json play = test::answer("open", {{"name", "robot.jsonl"}, {"maze", data_of(test::hook())}}, robot)["play"];
  EXPECT_EQ(play["maze"], data_of(test::hook()));
  EXPECT_THAT(play["checked"].get<std::string>(), Says("2 steps", "no readings"));
  EXPECT_EQ(play["blocked"], json::parse("[false,true]"));
}

TEST(PageOpens, NoRecordThatIsNone) {
  const std::string good = write_record(recorded("flood"));
  const json said = refused(changed(good, "\"step\":2", "\"step\":3"), "walk.jsonl");
  EXPECT_THAT(error_in(said), Says("walk.jsonl ", "not a readable record"));
  expect_problem(said, 3, 1, "step 3", "step 2");
  expect_problem(refused("{\"labmouse\":\"record\",\"for"), 1, 26, "JSON");
  expect_problem(refused("{ \"labmouse\" : \"mms record\",\n"), 1, 29, "JSON");
}

TEST(PageOpens, NoRecordOfAnotherMaze) {
  const std::string good = write_record(recorded("flood"));
  const json said = refused(changed(good, "\"reading\":[0,4,", "\"reading\":[0,3,"), "walk.jsonl");
  EXPECT_THAT(error_in(said), Says("walk.jsonl ", "match its maze"));
  EXPECT_EQ(said["problems"][0]["line"], 0);
  EXPECT_THAT(said["problems"][0]["reason"].get<std::string>(), SaysAt("step 1", "(0,0)"));
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
    "world": "mms", "mouse": "mms:./mouse", "rules": null, "seed": null, "outcome": "complete: exit code 0", "finished": false,
    "search_steps": 3, "speed_steps": 0, "discovered": null, "visited": null, "last_words": "",
    "checked": "", "ended": true, "x": [1, 1, 5, 1], "y": [1, 1, 1, 1], "heading": [0, 2, 2, 0], "run": [0, 0, 0, 0],
    "action": ["turnRight", "moveForward 5", "ackReset"], "blocked": [false, true, false],
    "left": [], "ahead": [], "right": [], "known": [], "goal_frame": null, "reset_frame": 3, "entered": [[], [1, 2], []],
    "route": [[0, 0], [1, 0]], "distances": [1, 0, 1], "reasons": [], "loses": [],
    "traits": {"clock": "seconds", "unit": "", "digits": 1, "bound": "the best possible score under the rules of mms",
               "runs": ["running"], "draws": true, "pictured": false},
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
  EXPECT_THAT(error_in(said), Says("mms.jsonl ", "match its maze"));
  EXPECT_THAT(said["problems"][0]["reason"].get<std::string>(), SaysAt("event 2", "ack at [5,1]"));
  expect_problem(refused(changed(good, "\"place\":[3,1]", "\"place\":[3]")), 3, 1, "place", "[x, y]");
}

TEST(PageOpens, Pages) {
  EXPECT_THAT(error_in(refused("<!DOCTYPE html>\n<html><title>labmouse</title>", "report.html")),
              Says("report.html ", "labmouse page"));
  EXPECT_THAT(error_in(refused("\xEF\xBB\xBF <html>", "x.html")), Says("x.html ", "page or a picture"));
  EXPECT_THAT(error_in(refused("<svg>labmouse</svg>", "x.svg")), Says("x.svg ", "page or a picture"));
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
  more["groups"][0]["mice"][0]["results"][0]["extra"] = {{"more", {1}}, {"known", 1}};
  more["extra"] = 1;
  json expected = known;
  expected["groups"][0]["mice"][0]["results"][0]["extra"] = {{"known", 1}};
  EXPECT_EQ(opened(more.dump())["results"], expected);
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
  EXPECT_THAT(reason("/groups/0/world", 3), Says("'groups[0].world'", "string"));
  EXPECT_THAT(reason("/groups/0/mice/0/runs", "x"), Says("'groups[0].mice[0].runs'", "whole number"));
  EXPECT_THAT(reason("/groups/0/mice/0/interval", {3}), Says("'groups[0].mice[0].interval'", "[low, high]"));
  EXPECT_THAT(reason("/groups/0/mice/0/results/0/outcome", nullptr),
              Says("'groups[0].mice[0].results[0].outcome'", "string"));
}

TEST(PageOpens, ResultsOfMms) {
  std::vector<Race> races = {test::race_of("flood"), test::imagined_race({"mms:a"}, {test::plank()})};
  test::imagine(races[1], 0, 0, test::imagined_run(4, 1, 10, 2));
  json whole = json::parse(json_of(races, {}));
  const json group = opened(whole.dump())["results"]["groups"][1];
  EXPECT_EQ(group["world"], "mms");
  EXPECT_EQ(group["mazes"], whole["groups"][1]["mazes"]);
  EXPECT_EQ(group["mice"][0]["results"][0]["score"], whole["groups"][1]["mice"][0]["results"][0]["score"]);
  whole["groups"][1]["mice"][0]["results"][0]["maze"] = "other";
  EXPECT_THAT(refused(whole.dump())["problems"][0]["reason"].get<std::string>(),
              Says("'groups[1].mice[0].results[0].maze'", "mazes"));
}

json refused_with(const char* field, const json& value) {
  json bad = results();
  bad[json::json_pointer(field)] = value;
  return refused(bad.dump(), "race.json");
}

TEST(PageOpens, NothingThatIsTooDeepToBeOurs) {
  const json said = refused(std::string(40, '[') + std::string(40, ']'));
  EXPECT_THAT(error_in(said), Says("file ", "JSON", "nested"));
  EXPECT_EQ(refused(std::string(1'000'000, '['))["error"], said["error"]);
  EXPECT_THAT(error_in(refused("[\"" + std::string(40, '[') + "\\\"[\"]")), Says("file ", "JSON", "neither a record"));
}

TEST(PageOpens, NoResultsWithWrongFields) {
  const auto reason = [](const char* field, const json& value) -> std::string {
    return refused_with(field, value)["problems"][0]["reason"];
  };
  EXPECT_THAT(error_in(refused_with("/seed", -1)), Says("race.json ", "race results"));
  EXPECT_THAT(reason("/seed", -1), Says("'seed'", "2^64 - 1"));
  EXPECT_THAT(reason("/groups", 3), Says("'groups'", "list"));
  EXPECT_THAT(reason("/groups/0/mice", 3), Says("'groups[0].mice'", "list"));
  EXPECT_THAT(reason("/groups/0/mice/1/name", 3), Says("'groups[0].mice[1].name'", "string"));
  EXPECT_THAT(reason("/groups/0/mice/0/interval", {1}), Says("'groups[0].mice[0].interval'", "[low, high]"));
  EXPECT_THAT(reason("/groups/0/mice/1/mean_score", "low"), Says("'groups[0].mice[1].mean_score'", "number"));
  EXPECT_THAT(reason("/groups/0/mice/1/results/2/maze", "other"), Says("'groups[0].mice[1].results[2].maze'", "mazes"));
  EXPECT_THAT(reason("/groups/0/mice/1/results/2", 3), Says("'groups[0].mice[1].results[2]'", "object"));
  EXPECT_THAT(reason("/groups/0/mazes/0/width", 1.5), Says("'groups[0].mazes[0].width'", "whole number"));
  EXPECT_THAT(reason("/skipped/0/reasons", {1}), Says("'skipped[0].reasons[0]'", "string"));
  EXPECT_THAT(reason("/groups", {3}), Says("'groups[0]'", "object"));
}

TEST(PageOpens, ResultsOfAnEarlierVersionWhereTheyHaveWhatIsNeeded) {
  json now = results();
  now["labmouse"] = "0.0.1";
  json& group = now["groups"][0];
  // A race in steps stood at the top.
  json old = now;
  old.erase("groups");
  for (const char* key : {"budget", "mazes", "mice", "notes"}) old[key] = group[key];
  for (const char* key : {"unit", "score", "bound", "failure_score", "limit_score", "columns"}) group.erase(key);
  EXPECT_EQ(opened(old.dump())["results"], now);
  old["mice"][0].erase("runs");
  const json said = refused(old.dump(), "old.json");
  EXPECT_THAT(error_in(said), Says("old.json ", "race results", "0.0.1", version()));
  expect_problem(said, 0, 0, "'groups[0].mice[0].runs'", "missing");
}

TEST(PageOpens, NoJsonThatIsNone) {
  const json said = refused("{\n  \"mice\": [1,\n  }\n", "race.json");
  EXPECT_THAT(error_in(said), Says("race.json ", "JSON"));
  expect_problem(said, 3, 3, "JSON", "'}'");
  EXPECT_THAT(error_in(refused("[1]", "x")), Says("x ", "JSON", "neither a record"));
}

TEST(JsonProblem, HasItsPlace) {
  const auto place = [](std::string_view text) {
    const Problem at = json_problem(text);
    return std::pair(at.line, at.column);
  };
  EXPECT_EQ(place("{,"), std::pair(1, 2));
  EXPECT_EQ(place("\n\n  x"), std::pair(3, 3));
  EXPECT_EQ(place("[1e999]"), std::pair(1, 2));
  EXPECT_EQ(place("[\n"), std::pair(2, 1));
  EXPECT_EQ(place(""), std::pair(1, 1));
  EXPECT_THAT(json_problem("[1e999]").reason, Says("JSON", "'1e999'"));
}

}  // namespace
}  // namespace labmouse
