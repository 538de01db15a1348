#include "labmouse/lab/standings/mms_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "labmouse/lab/pictures/mms_picture.hpp"
#include "labmouse/lab/records/mms_record.hpp"
#include "labmouse/lab/records/mms_statistics_json.hpp"
#include "labmouse/lab/standings/race_report.hpp"
#include "tests/lab/mms_fixture.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::ordered_json;
using test::imagined_race;
using test::imagined_run;
using test::loop;
using test::plank;
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

/// Two mice in two mazes; one of them hung and talked in one of these.
MmsRace two_mice() {
  MmsRace race = imagined_race({"./good", "python3 bad.py"}, {loop(), plank()});
  MmsRun hung;
  hung.outcome = MmsOutcome::hung;
  hung.end = "wrote no line for 1 s";
  hung.lines = 10;
  hung.invalid_lines = 2;
  hung.log = {"line 3: 'turnright' is no command", "line 4: '' is no command"};
  hung.errors = "Traceback\n  File \x1b[31m\nKeyError: 'north'\n";
  race.results = {{0, 0, true, imagined_run(31, 8, 31.5F, 8)},
                  {0, 1, true, imagined_run(2, 0, 2, 1)},
                  {1, 0, true, hung},
                  {1, 1, true, imagined_run(2, 0, 24, 10)}};
  return race;
}

TEST(MmsTable, ShowsEveryMouseBestFirst) {
  const std::string table = table_of(two_mice(), false);
  EXPECT_THAT(table, HasSubstr("world of mms, 2 mice, 2 mazes"));
  EXPECT_THAT(table, ContainsRegex("\n./good +2/2 +22\\.6 +2\\.3-43\\.0 "));
  EXPECT_THAT(table, ContainsRegex("\npython3 bad.py +1/2 +1002\\.7 +5-2000 +5\\.4 "));
  EXPECT_LT(table.find("\n./good"), table.find("\npython3 bad.py"));
}

TEST(MmsTable, FitsIntoNinetyColumns) {
  for (const std::string& line : lines(table_of(two_mice(), false))) EXPECT_LE(line.size(), 90U) << line;
}

TEST(MmsTable, SaysWhatTheScoreIs) {
  EXPECT_THAT(table_of(two_mice(), false), HasSubstr("effective distance + turns of the best run + a tenth of all"));
}

TEST(MmsTable, SaysHowRunsFailedAndWhatTheyWroteLast) {
  const std::string table = table_of(two_mice(), false);
  EXPECT_THAT(table, HasSubstr("  python3 bad.py: hung 1; first in loop: wrote no line for 1 s\n"
                               "    | Traceback\n    |   File [31m\n    | KeyError: 'north'\n"));
  MmsRace good = two_mice();
  for (MmsResult& result : good.results) result.run.outcome = MmsOutcome::complete;
  EXPECT_THAT(table_of(good, false), Not(HasSubstr("Ended otherwise")));
}

TEST(MmsTable, SaysWhichLinesAreNoCommands) {
  EXPECT_THAT(table_of(two_mice(), false),
              HasSubstr("  python3 bad.py: 2 of 30; first in loop: line 3: 'turnright' is no command\n"));
}

TEST(MmsTable, SaysWhereItWasStopped) {
  MmsRace race = two_mice();
  EXPECT_THAT(table_of(race, false), Not(HasSubstr("Stopped early")));
  race.stopped = true;
  race.results[0].done = false;
  EXPECT_THAT(table_of(race, false), HasSubstr("Stopped early: 3 of 4 runs done.\n"));
}

TEST(MmsTable, SaysWhichMazesAreOtherInMms) {
  MmsRace race = imagined_race({"a"}, {shaft(), test::corridor()});
  race.results = {{0, 0, true, {}}, {0, 1, true, imagined_run(2, 1, 2, 1)}};
  const std::string table = table_of(race, false);
  EXPECT_THAT(table, HasSubstr("Left out of all means: 1 maze whose centre cannot be reached (shaft)."));
  EXPECT_THAT(table, HasSubstr("its goal is the centre, other than 1 maze says"));
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
  const MmsRace mms = two_mice();
  const Race race = test::race_of("flood");
  const Json json = Json::parse(json_of(race, {}, &mms));
  ASSERT_EQ(json.at("groups").size(), 1U);
  EXPECT_EQ(json.at("groups")[0].at("world"), "mms");
  EXPECT_EQ(json.at("mice")[0].at("name"), "flood");
  EXPECT_FALSE(Json::parse(json_of(race, {})).contains("groups"));
}

TEST(MmsJson, ARaceThatWasStoppedInOneWorldWasStopped) {
  MmsRace mms = two_mice();
  const Race race = test::race_of("flood");
  EXPECT_EQ(Json::parse(json_of(race, {}, &mms)).at("stopped"), false);
  mms.stopped = true;
  EXPECT_EQ(Json::parse(json_of(race, {}, &mms)).at("stopped"), true);
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
  const MmsStatistics statistics = two_mice().results[0].run.statistics;
  for (const auto& item : result.at("statistics").items())
    EXPECT_FLOAT_EQ(item.value().get<float>(), std::stof(*statistic_reply(statistics, item.key()))) << item.key();
  EXPECT_EQ(result.at("statistics").at("total-effective-distance").dump(), "31.5");
  EXPECT_EQ(result.at("statistics").at("best-run-turns").dump(), "8");
}

TEST(MmsJson, AnUnsolvedRunLacksItsBestRunAndRatios) {
  const Json result = group_json(two_mice()).at("mice")[1].at("results")[0];
  EXPECT_EQ(result.at("score"), 2000);
  EXPECT_EQ(result.at("outcome"), "hung");
  EXPECT_TRUE(result.at("best_run").is_null());
  EXPECT_TRUE(result.at("ratio").is_null());
  EXPECT_TRUE(result.at("run_ratio").is_null());
  EXPECT_EQ(result.at("log").size(), 2U);
  EXPECT_EQ(result.at("errors").at(0), "Traceback");
}

TEST(MmsJson, HasTheMeansOfTheTable) {
  const Json mouse = group_json(two_mice()).at("mice")[1];
  EXPECT_EQ(mouse.at("name"), "mms:python3 bad.py");
  EXPECT_EQ(mouse.at("solved"), 1);
  EXPECT_DOUBLE_EQ(mouse.at("mean_score").get<double>(), (2000.0 + 5.4) / 2);
  EXPECT_EQ(mouse.at("outcomes"), Json({{"complete", 1}, {"hung", 1}}));
  EXPECT_EQ(mouse.at("invalid_lines"), 2);
}

TEST(MmsJson, AMouseHasItsOwnResultsThatAreDone) {
  MmsRace race = two_mice();
  EXPECT_EQ(group_json(race).at("mice")[0].at("results").size(), 2U);
  race.results[0].done = false;
  EXPECT_EQ(group_json(race).at("mice")[0].at("results").size(), 1U);
  EXPECT_EQ(lines(csv_of(race)).size(), 4U);
}

TEST(MmsJson, TextsThatAreNoUtf8DoNoHarm) {
  MmsRace race = two_mice();
  race.results[2].run.errors = "caf\xe9\n";
  race.results[2].run.log = {"\xff"};
  EXPECT_NO_THROW(Json::parse(json_of(test::race_of("flood"), {}, &race)));
}

TEST(MmsCsv, HasALineForEachRun) {
  const auto list = lines(csv_of(two_mice()));
  ASSERT_EQ(list.size(), 5U);
  EXPECT_EQ(
      list[0],
      "mouse,maze,outcome,end,solved,best_run,possible_run,possible_score,total-distance,total-effective-distance,"
      "total-turns,current-run-distance,current-run-effective-distance,current-run-turns,best-run-distance,"
      "best-run-effective-distance,best-run-turns,score,lines,invalid_lines,simulated_seconds,seconds");
  for (const std::string& line : list) EXPECT_EQ(std::count(line.begin(), line.end(), ','), 21) << line;
  EXPECT_THAT(list[3], HasSubstr("mms:python3 bad.py,loop,hung,wrote no line for 1 s,false,,"));
}

TEST(MmsReport, PutsTheScoreBesideTheBound) {
  const std::string text = report_of("./mouse", plank(), imagined_run(2, 0, 24, 9));
  const MmsBound bound = mms_bound_of(plank().maze);
  EXPECT_THAT(text, HasSubstr("./mouse in plank: score 5.3 = 2 best run + 33 total / 10; bound " +
                              fmt::format("{:g}", *bound.score)));
  EXPECT_THAT(text, HasSubstr("complete: exit code 0; 20 lines, 12.5 s in mms"));
  EXPECT_THAT(report_of("./mouse", shaft(), {}), HasSubstr("unsolved, score 2000; the centre cannot be reached"));
}

TEST(MmsReport, SaysWhatWasWrong) {
  const std::string text = report_of("./mouse", loop(), two_mice().results[2].run);
  EXPECT_THAT(
      text,
      HasSubstr("2 lines that are no command, which mms does not answer:\n  line 3: 'turnright' is no command\n"));
  EXPECT_THAT(text, HasSubstr("  | KeyError: 'north'\n"));
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
}

/// The record of a run of these lines.
std::vector<Json> recorded(const std::vector<std::string>& asked, std::int64_t most = most_recorded_events) {
  MmsRecorder recorder("mms:./mouse", loop(), most);
  MmsHost host(loop().maze, {});
  host.on_event([&](const MmsEvent& event) { recorder.add(event); });
  std::string replies;
  for (const std::string& line : asked) host.obey(line, replies);
  MmsRun run;
  run.end = "exit code 0";
  run.statistics = host.statistics();
  std::vector<Json> record;
  for (const std::string& line : lines(recorder.finish(run))) record.push_back(Json::parse(line));
  return record;
}

TEST(MmsRecord, BeginsWithTheMazeAsMmsTakesIt) {
  const Json header = recorded({}).front();
  EXPECT_EQ(header.at("labmouse"), "mms record");
  EXPECT_EQ(header.at("format"), 1);
  EXPECT_EQ(header.at("mouse").at("name"), "mms:./mouse");
  EXPECT_EQ(header.at("maze").at("name"), "loop");
  EXPECT_EQ(header.at("maze").at("start"), Json({0, 0}));
  EXPECT_EQ(header.at("maze").at("goals"), Json({{2, 2}}));
  EXPECT_EQ(header.at("maze").at("drawing").size(), 11U);
}

TEST(MmsRecord, HasALineForWhatMovedTurnedOrDrew) {
  const auto record =
      recorded({"mazeWidth", "moveForward 2", "turnRight45", "setText 1 1 caf\xe9", "ackReset", "what"});
  ASSERT_EQ(record.size(), 6U);
  EXPECT_EQ(record[1].at("line"), "moveForward 2");
  EXPECT_EQ(record[1].at("reply"), "ack");
  EXPECT_EQ(record[1].at("place"), Json({1, 5}));
  EXPECT_EQ(record[1].at("heading"), "north");
  EXPECT_NEAR(record[1].at("clock").get<double>(), 0.79, 0.01);
  EXPECT_EQ(record[2].at("heading"), "north-east");
  EXPECT_FALSE(record[3].contains("reply"));
  EXPECT_EQ(record[4].at("place"), Json({1, 1}));
}

TEST(MmsRecord, EndsWithHowItWent) {
  const Json end = recorded({"moveForward 2"}).back();
  EXPECT_EQ(end.at("outcome"), "complete");
  EXPECT_EQ(end.at("end"), "exit code 0");
  EXPECT_EQ(end.at("statistics").at("total-distance"), 4);
}

TEST(MmsRecord, IsCutWhereItIsTooLong) {
  const auto record = recorded({"turnLeft", "turnLeft", "turnLeft", "turnLeft"}, 2);
  ASSERT_EQ(record.size(), 5U);
  EXPECT_EQ(record[3], Json({{"left_out", 2}}));
  EXPECT_EQ(recorded({"turnLeft", "turnLeft"}, 2).size(), 4U);
}

TEST(MmsDrawing, ShowsTextsColoursAndTheMouse) {
  MmsCanvas canvas(plank().maze.size());
  canvas.set_text({0, 0}, "  7  ");
  canvas.set_colour({1, 0}, 'y');
  canvas.set_colour({2, 0}, 'B');
  const DrawingLayers layers = mms_layers(canvas, {{5, 1}, Compass::south_east});
  const std::string text = draw_text(as_in_mms(plank().maze), layers, false);
  EXPECT_THAT(text, HasSubstr("|S7   G   > |"));
  EXPECT_THAT(draw_text(as_in_mms(plank().maze), layers, true), HasSubstr("30;48;5;226m"));
  EXPECT_THAT(draw_text(as_in_mms(plank().maze), layers, true), HasSubstr("97;48;5;18m"));
}

TEST(MmsDrawing, PlacesAreInCells) {
  EXPECT_EQ(place_text({{1, 1}, Compass::north}), "at (0,0) heading north");
  EXPECT_EQ(place_text({{4, 3}, Compass::north_west}), "at (1.5,1) heading north-west");
}

}  // namespace
}  // namespace labmouse
