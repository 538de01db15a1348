#include "labmouse/lab/mms/mms_world.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "labmouse/external/mms/run.hpp"
#include "labmouse/lab/bounds/mms_bound.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/text/last_lines.hpp"
#include "tests/lab/mms/mms_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::ordered_json;
using test::hook;
using test::imagine;
using test::imagined_race;
using test::imagined_run;
using test::in_mms;
using test::loop;
using test::mms_mouse;
using test::plank;
using test::Says;
using test::shaft;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> list;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) list.push_back(line);
  return list;
}

/// What the race says of a mouse under that name in JSON.
Json figure(const Race& race, const Standing& standing, std::string_view key) {
  return Json::parse(text_of(figure_of(race, standing, key)));
}

/// A mouse that knows the maze and asks for the moves of its best run.
Contestant witness_of(const Maze& maze) {
  std::vector<std::string> words;
  for (const std::string& line : mms_best_commands(maze)) words.push_back("ask:" + line);
  return mms_mouse("witness", words);
}

TEST(MmsWorld, HoldsOneRunInAMaze) {
  const Race race =
      hold_race({mms_mouse("b", {"ask:mazeWidth"}), mms_mouse("a", {"exit:2"})}, {plank(), loop()}, in_mms());
  EXPECT_FALSE(race.stopped);
  ASSERT_EQ(race.results.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(race.results[i].done);
    EXPECT_EQ(figure_of(race, race.results[i], "end"), Value(std::string(i < 2 ? "exit code 2" : "exit code 0")));
    EXPECT_EQ(figure_of(race, race.results[i], "lines"), Value(i < 2 ? 0 : 1));
  }
}

TEST(MmsWorld, HoldsOneRunWhateverAMouseAsksFor) {
  Contestant mouse = mms_mouse("a", {"exit:2"});
  mouse.runs = 3;
  EXPECT_EQ(hold_race({mouse}, {plank()}, in_mms()).results.size(), 1U);
}

TEST(MmsWorld, AMouseThatPlaysABestRunScoresTheBound) {
  for (const NamedMaze& maze : {plank(), test::corridor(), loop()}) {
    const Race race = hold_race({witness_of(maze.maze)}, {maze}, in_mms());
    EXPECT_DOUBLE_EQ(*race.results[0].ratio, 1.0) << maze.name;
    EXPECT_DOUBLE_EQ(*number_of(figure_of(race, race.results[0], "run_ratio")), 1.0) << maze.name;
    EXPECT_EQ(race.results[0].outcome, "finished");
  }
}

TEST(MmsWorld, TheShareIsOfTheCellsThatItDroveThrough) {
  // There and back is no further cell, and the last of three is not visited.
  const Race race = hold_race(
      {mms_mouse("a", {"ask:turnRight", "ask:moveForward", "ask:turnRight", "ask:turnRight", "ask:moveForward"})},
      {plank()}, in_mms());
  EXPECT_DOUBLE_EQ(*number_of(figure_of(race, race.results[0], visited_share)), 2.0 / 3);
}

TEST(MmsWorld, KeepsLittleOfLongTexts) {
  const Race race =
      hold_race({mms_mouse("chatter", {"burst:50:what?", "errors:one", "errors:two", "errors:three", "errors:four",
                                       "errors:five", "errors:" + std::string(1000, 'x'), "say:setColor 0 0 G"})},
                {plank()}, in_mms());
  const auto said = [&](std::string_view key) { return Json::parse(text_of(figure_of(race, race.results[0], key))); };
  EXPECT_EQ(said("invalid_lines"), 50);
  EXPECT_EQ(said("log").size(), 3U);
  EXPECT_EQ(said("errors"), Json({"two", "three", "four", "five", std::string(kept_text, 'x')}));
}

TEST(MmsWorld, ARunThatWasUnderWayIsEndedAndLeftOut) {
  std::atomic<bool> stop = false;
  RaceHooks hooks;
  hooks.stop = &stop;
  hooks.finished = [&](const Race&, const ContestResult& result, const ContestOutput&) {
    EXPECT_EQ(result.mouse, 0U);
    stop = true;
  };
  RaceOrder order = in_mms();
  order.jobs = 2;
  const Race race = hold_race({mms_mouse("a", {}), mms_mouse("b", {"ask:turnLeft", "hang"})}, {plank()}, order, hooks);
  EXPECT_TRUE(race.stopped);
  EXPECT_FALSE(race.results[1].done);
}

TEST(MmsWorld, HandsItsOptionsOn) {
  MmsOptions options;
  options.strict = true;
  const Race race = hold_race({mms_mouse("a", {"say:what?", "hang"})}, {plank()}, in_mms(options));
  EXPECT_EQ(figure_of(race, race.results[0], "outcome"), Value(std::string(name_of(MmsOutcome::invalid))));
}

TEST(LastLines, AreTheLastFiveThatSaySomething) {
  EXPECT_THAT(last_lines("a\nb\n\n  \nc\nd\ne\r\n\r\nf\n"), ElementsAre("b", "c", "d", "e\r", "f"));
  EXPECT_THAT(last_lines("only"), ElementsAre("only"));
  EXPECT_THAT(last_lines(""), ElementsAre());
  EXPECT_THAT(last_lines("\n\n"), ElementsAre());
}

TEST(LastLines, LeaveOutTheMarksOfATraceback) {
  EXPECT_THAT(last_lines("  a = b / c\n      ~~^~~\n    ^\n ~\t~\nd ^ e\n"), ElementsAre("  a = b / c", "d ^ e"));
}

/// Two mice in two mazes with a way to the centre and one without; one contest was not held.
Race three_mazes() {
  Race race = imagined_race({"a", "b"}, {loop(), plank(), shaft()});
  MmsRun unfinished;
  unfinished.outcome = MmsOutcome::hung;
  unfinished.statistics.total_effective_distance = 100;
  unfinished.lines = 7;
  unfinished.invalid_lines = 2;
  imagine(race, 0, 0, imagined_run(40, 10, 180, 20));
  imagine(race, 0, 1, unfinished);
  imagine(race, 0, 2, unfinished);
  imagine(race, 1, 0, imagined_run(30, 6, 30, 6));
  imagine(race, 1, 1, imagined_run(2, 0, 2, 1));
  return race;
}

TEST(MmsStandings, CountTheScoreOfMmsForUnfinishedMazes) {
  const Race race = three_mazes();
  const auto standings = standings_of(race);
  ASSERT_EQ(standings.size(), 2U);
  EXPECT_EQ(standings[0].mouse, 1U);  // the better one
  const Standing& a = standings[1];
  EXPECT_EQ(a.runs, 2);
  EXPECT_EQ(a.finished, 1);
  EXPECT_DOUBLE_EQ(*a.mean_all, (70.0 + 2000.0) / 2);
  EXPECT_DOUBLE_EQ(*a.mean_finished, 70.0);
  EXPECT_DOUBLE_EQ(figure(race, a, "mean_best_run"), 50.0);
  EXPECT_DOUBLE_EQ(figure(race, a, "mean_total"), (200.0 + 100.0) / 2);
  EXPECT_LE(a.interval.low, *a.mean_all);
  EXPECT_GE(a.interval.high, *a.mean_all);
  const MmsBound bound = mms_bound_of(loop().maze);
  EXPECT_DOUBLE_EQ(*a.mean_ratio, 70.0 / *bound.score);
  EXPECT_DOUBLE_EQ(figure(race, a, "mean_run_ratio"), 50.0 / *bound.run);
}

TEST(MmsStandings, CountLinesAndOutcomesOfAllThatWasDone) {
  const Race race = three_mazes();
  const Standing a = standings_of(race)[1];
  EXPECT_EQ(figure(race, a, "lines"), 34);
  EXPECT_EQ(figure(race, a, "invalid_lines"), 4);
  EXPECT_EQ(figure(race, a, "outcomes"), Json({{"complete", 1}, {"hung", 2}}));
}

TEST(MmsStandings, LeaveOutWhatWasNotDone) {
  Race race = three_mazes();
  for (ContestResult& result : race.results) result.done = false;
  const Standing standing = standings_of(race)[0];
  EXPECT_EQ(standing.runs, 0);
  EXPECT_FALSE(standing.mean_all || standing.mean_ratio);
  for (const char* mean : {"mean_total", "mean_seconds"})
    EXPECT_EQ(figure_of(race, standing, mean), Value(nullptr)) << mean;
}

TEST(MmsStandings, AMazeThatStartsInItsGoalHasNoRatio) {
  Race race = imagined_race({"a"}, {hook()});
  imagine(race, 0, 0, imagined_run(0, 0, 0, 1));
  EXPECT_EQ(standings_of(race)[0].finished, 1);
  EXPECT_EQ(figure_of(race, standings_of(race)[0], "mean_run_ratio"), Value(nullptr));
}

/// A run that hung and talked.
MmsRun hung() {
  MmsRun run;
  run.outcome = MmsOutcome::hung;
  run.end = "wrote no line for 1 s";
  run.lines = 10;
  run.invalid_lines = 2;
  run.log = {"line 3: 'turnright' is no command", "line 4: '' is no command"};
  run.errors = "Traceback\n  File \x1b[31m\nKeyError: 'north'\n";
  return run;
}

/// Two mice in two mazes, one of which did so in the first.
Race two_mice(const MmsRun& first_of_second = hung()) {
  Race race = imagined_race({"./good", "python3 bad.py"}, {loop(), plank()});
  imagine(race, 0, 0, imagined_run(31, 8, 31.5F, 8));
  imagine(race, 0, 1, imagined_run(2, 0, 2, 1));
  imagine(race, 1, 0, first_of_second);
  imagine(race, 1, 1, imagined_run(2, 0, 24, 10));
  return race;
}

Json group_json(const Race& race) { return Json::parse(json_of(race, {})).at("groups").at(0); }

TEST(MmsTable, ShowsEveryMouseBestFirst) {
  const std::string table = table_of(two_mice(), false);
  EXPECT_THAT(table, Says("world mms", "2 mice", "2 mazes"));
  EXPECT_THAT(table, ContainsRegex("\n./good +2/2 +22\\.6 +0\\.0-280\\.9 "));
  EXPECT_THAT(table, ContainsRegex("\npython3 bad.py +1/2 +1002\\.7 +0-13675 +4\\.50 "));
  EXPECT_LT(table.find("\n./good"), table.find("\npython3 bad.py"));
}

TEST(MmsTable, FitsIntoNinetyColumns) {
  for (const std::string& line : lines(table_of(two_mice(), false))) EXPECT_LE(line.size(), 90U) << line;
}

TEST(MmsTable, SaysWhatTheScoreIs) {
  EXPECT_THAT(table_of(two_mice(), false), Says("effective distance + turns", "best run", "a tenth"));
}

TEST(MmsTable, SaysHowRunsFailedAndWhatTheyWroteLast) {
  const std::string table = table_of(two_mice(), false);
  EXPECT_THAT(table, Says("\n  python3 bad.py: hung 1;",
                          "loop: wrote no line for 1 s\n"
                          "    | Traceback\n    |   File [31m\n    | KeyError: 'north'\n"));
  MmsRun complete = hung();
  complete.outcome = MmsOutcome::complete;
  EXPECT_THAT(table_of(two_mice(complete), false), Not(HasSubstr("Traceback")));
}

TEST(MmsTable, NamesNoFailureInAMazeThatDoesNotCount) {
  Race race = imagined_race({"a"}, {shaft(), plank()});
  MmsRun failed = hung();
  failed.end = "in the shaft";
  imagine(race, 0, 0, failed);
  imagine(race, 0, 1, imagined_run(2, 0, 2, 1));
  EXPECT_THAT(table_of(race, false), Not(HasSubstr("in the shaft")));
  imagine(race, 0, 1, hung());
  EXPECT_THAT(table_of(race, false), AllOf(Says("a: hung 1; first in plank"), Not(HasSubstr("in the shaft"))));
}

TEST(MmsTable, SaysWhichLinesAreNoCommands) {
  EXPECT_THAT(table_of(two_mice(), false),
              Says("\n  python3 bad.py: 2 of 30;", "loop: line 3: 'turnright' is no command\n"));
}

TEST(MmsTable, SaysWhereItWasStopped) {
  Race race = two_mice();
  EXPECT_THAT(table_of(race, false), Not(HasSubstr("Stopped")));
  race.stopped = true;
  race.results[0].done = false;
  EXPECT_THAT(table_of(race, false), Says("Stopped", "3 of 4 contests"));
}

TEST(MmsTable, SaysWhichMazesAreOtherInMms) {
  Race race = imagined_race({"a"}, {shaft(), test::corridor()});
  imagine(race, 0, 0, {});
  imagine(race, 0, 1, imagined_run(2, 1, 2, 1));
  const std::string table = table_of(race, false);
  EXPECT_THAT(table, Says("Left out", "1 maze whose centre", "(shaft)"));
  EXPECT_THAT(table, Says("goal is the centre", "unlike", "1 maze says"));
  EXPECT_THAT(table, ContainsRegex("\na +1/1 "));
}

TEST(MmsTable, ShortensLongCommandsAndKeepsThemDifferent) {
  const std::string path = "/home/somebody/mice/mms/mine/", one = "python3 " + path + "one.py",
                    two = "python3 " + path + "two.py";
  EXPECT_THAT(table_of(imagined_race({one, two}, {plank()}), false), HasSubstr("\n...somebody/mice/mms/mine/one.py "));
  const std::string tail = "/a/long/path/to/the/same/mouse.py";
  const std::string both = table_of(imagined_race({"python2 " + tail, "python3 " + tail}, {plank()}), false);
  EXPECT_THAT(both, HasSubstr("\npython2 " + tail));
}

TEST(MmsTable, NamesSteerNoTerminal) {
  EXPECT_THAT(table_of(imagined_race({"a\x1b[2J"}, {plank()}), false), Not(HasSubstr("\x1b")));
}

TEST(MmsTable, ColoursOnlyWhereAsked) {
  EXPECT_THAT(table_of(two_mice(), false), Not(HasSubstr("\x1b")));
  EXPECT_THAT(table_of(two_mice(), true), HasSubstr("\x1b["));
}

TEST(MmsJson, IsAGroupOfTheRace) {
  const std::vector<Race> races = {test::race_of("flood"), two_mice()};
  const Json json = Json::parse(json_of(races, {}));
  ASSERT_EQ(json.at("groups").size(), 2U);
  EXPECT_EQ(json.at("groups")[0].at("mice")[0].at("name"), "flood");
  EXPECT_EQ(json.at("groups")[1].at("world"), "mms");
}

TEST(MmsJson, ARaceThatWasStoppedInOneWorldWasStopped) {
  std::vector<Race> races = {test::race_of("flood"), two_mice()};
  EXPECT_EQ(Json::parse(json_of(races, {})).at("stopped"), false);
  races[1].stopped = true;
  EXPECT_EQ(Json::parse(json_of(races, {})).at("stopped"), true);
}

TEST(MmsJson, AMazeHasItsLimits) {
  const Json json = group_json(imagined_race({"a"}, {plank(), shaft()}));
  const MmsBound bound = mms_bound_of(plank().maze);
  EXPECT_EQ(
      json.at("mazes")[0],
      Json({{"name", "plank"}, {"width", 3}, {"height", 1}, {"best_run", *bound.run}, {"best_score", *bound.score}}));
  EXPECT_TRUE(json.at("mazes")[1].at("best_run").is_null());
  EXPECT_TRUE(json.at("mazes")[1].at("best_score").is_null());
}

TEST(MmsJson, AResultHasAllValuesOfGetStatUnderTheirNames) {
  const Json group = group_json(two_mice());
  const Json& result = group.at("mice")[0].at("results")[0];
  std::vector<std::string> names;
  for (const auto& item : result.at("statistics").items()) names.push_back(item.key());
  const auto known = statistic_names();
  EXPECT_THAT(names, ::testing::UnorderedElementsAreArray(std::vector<std::string>(known.begin(), known.end())));
  const MmsStatistics statistics = imagined_run(31, 8, 31.5F, 8).statistics;
  for (const auto& item : result.at("statistics").items())
    EXPECT_FLOAT_EQ(item.value().get<float>(), std::stof(*statistic_reply(statistics, item.key()))) << item.key();
  EXPECT_EQ(result.at("statistics").at("total-effective-distance").dump(), "31.5");
  EXPECT_EQ(result.at("statistics").at("best-run-turns").dump(), "8");
}

TEST(MmsJson, AnUnfinishedRunLacksItsBestRunAndRatios) {
  const Json result = group_json(two_mice()).at("mice")[1].at("results")[0];
  EXPECT_EQ(result.at("finished"), false);
  EXPECT_EQ(result.at("score"), 2000);  // as in mms
  EXPECT_EQ(result.at("outcome"), "hung");
  EXPECT_TRUE(result.at("best_run").is_null());
  EXPECT_TRUE(result.at("ratio").is_null());
  EXPECT_TRUE(result.at("run_ratio").is_null());
  EXPECT_EQ(result.at("log").size(), 2U);
  EXPECT_EQ(result.at("errors").at(0), "Traceback");
}

TEST(MmsJson, ARunThatWasEndedForWhatItDidToTheMachineHasNoScore) {
  MmsRun run = imagined_run(2, 0, 24, 10);
  run.outcome = MmsOutcome::too_much_memory;
  const Json mice = group_json(two_mice(run)).at("mice");
  const Json result = mice[1].at("results")[0];
  EXPECT_EQ(result.at("outcome"), "too much memory");
  EXPECT_EQ(result.at("finished"), false);
  EXPECT_TRUE(result.at("score").is_null());
}

TEST(MmsTable, SaysWhatOfARunThatNeverEndedCounts) {
  MmsRun run = imagined_run(2, 0, 24, 10);
  run.outcome = MmsOutcome::never_ended;
  run.end = "had not ended after 5 lines; it repeats";
  EXPECT_THAT(table_of(two_mice(run), false),
              Says("never ended", "best run was finished", "never ended 1; first in loop: had not"));
  run.statistics.finished = false;
  EXPECT_THAT(table_of(two_mice(run), false), Not(HasSubstr("best run was finished")));
}

TEST(MmsJson, HasTheMeansOfTheTable) {
  const Json mouse = group_json(two_mice()).at("mice")[1];
  EXPECT_EQ(mouse.at("name"), "mms:python3 bad.py");
  EXPECT_EQ(mouse.at("finished"), 1);
  EXPECT_DOUBLE_EQ(mouse.at("mean_score").get<double>(), (2000.0 + 5.4) / 2);
  EXPECT_EQ(mouse.at("outcomes"), Json({{"complete", 1}, {"hung", 1}}));
  EXPECT_EQ(mouse.at("invalid_lines"), 2);
}

TEST(MmsJson, AMouseHasItsOwnResultsThatAreDone) {
  Race race = two_mice();
  EXPECT_EQ(group_json(race).at("mice")[0].at("results").size(), 2U);
  race.results[0].done = false;
  EXPECT_EQ(group_json(race).at("mice")[0].at("results").size(), 1U);
  EXPECT_EQ(lines(csv_of(race)).size(), 4U);
}

TEST(MmsJson, TextsThatAreNoUtf8DoNoHarm) {
  MmsRun run = hung();
  run.errors = "caf\xe9\n";
  run.log = {"\xff"};
  EXPECT_NO_THROW(Json::parse(json_of(two_mice(run), {})));
}

TEST(MmsCsv, HasALineForEachRun) {
  const auto list = lines(csv_of(two_mice()));
  ASSERT_EQ(list.size(), 5U);
  EXPECT_EQ(
      list[0],
      "mouse,maze,outcome,end,finished,best_run,possible_run,possible_score,total-distance,total-effective-distance,"
      "total-turns,current-run-distance,current-run-effective-distance,current-run-turns,best-run-distance,"
      "best-run-effective-distance,best-run-turns,score,lines,invalid_lines,simulated_seconds,seconds");
  for (const std::string& line : list) EXPECT_EQ(std::count(line.begin(), line.end(), ','), 21) << line;
  EXPECT_THAT(list[3], HasSubstr("mms:python3 bad.py,loop,hung,wrote no line for 1 s,false,,"));
}

}  // namespace
}  // namespace labmouse
