#include "labmouse/lab/studies/sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "labmouse/lab/races/value_json.hpp"
#include "labmouse/lab/standings/robot_comparison.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "tests/lab/drawing/drawing_samples.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/lab/xml_scanner.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

std::vector<std::string> values(std::string_view text) {
  const SweptValues swept = read_swept_values(text);
  EXPECT_EQ(swept.error, "");
  return swept.values;
}

std::string error(std::string_view text) {
  const SweptValues swept = read_swept_values(text);
  EXPECT_THAT(swept.values, IsEmpty());
  return swept.error;
}

TEST(SweepValues, AreExactDecimals) {
  EXPECT_THAT(values("p=0:1:0.1"),
              ElementsAre("0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1"));
  EXPECT_THAT(values("p=0.000001:0.000003:.000001"), ElementsAre("0.000001", "0.000002", "0.000003"));
  EXPECT_THAT(values("p=8:12:1.5"), ElementsAre("8", "9.5", "11"));
  EXPECT_THAT(values("p=-0.2:0.2:0.1"), ElementsAre("-0.2", "-0.1", "0", "0.1", "0.2"));
  EXPECT_THAT(values("p=100:100:10"), ElementsAre("100"));
}

TEST(SweepValues, OfAListStandAsGiven) {
  EXPECT_THAT(values("p=c,a,b"), ElementsAre("c", "a", "b"));
  EXPECT_THAT(values("p=3/5/3,4/5/4"), ElementsAre("3/5/3", "4/5/4"));
  EXPECT_EQ(read_swept_values("explore_frac=0.5").parameter, "explore_frac");
}

TEST(SweepValues, AreAtMostAThousand) {
  EXPECT_EQ(values("p=1:1000:1").size(), 1000U);
  EXPECT_THAT(error("p=0:1000:1"), Says("'0:1000:1'", "1001 values", "limit is 1000"));
  EXPECT_THAT(error("p=0:1000000000:0.000001"), Says("'0:1000000000:0.000001'", " values", "limit is 1000"));
  EXPECT_THAT(error("p=" + std::string(2000, ',')), HasSubstr("empty value"));
  std::string many = "p=1";
  for (int i = 0; i < 1000; ++i) many += ",1";
  EXPECT_THAT(error(many), Says("1001 values", "limit is 1000"));
}

TEST(SweepValues, AreRefusedWhereTheyAreNone) {
  const auto quoted = [](const std::string& text) { return "'" + text + "'"; };
  for (const char* bad : {"", "p", "=1:2:1"}) EXPECT_THAT(error(bad), Says(quoted(bad), "NAME=LOW:HIGH:STEP"));
  for (const char* bad : {"1:2", "1:2:3:4", "a:2:1", "1:2:", "0:1:0.0000001", "0:1e3:1", "0:2000000000:1000000000"})
    EXPECT_THAT(error("p=" + std::string(bad)), Says(quoted(bad), " LOW:HIGH:STEP"));
  for (const char* bad : {"0:1:0", "0:1:-1"})
    EXPECT_THAT(error("p=" + std::string(bad)), Says("step", quoted(bad), "above 0"));
  EXPECT_THAT(error("p=1:0:0.1"), Says("'1:0:0.1'", "below"));
  for (const char* bad : {"", "1,", "1,,2"})
    EXPECT_THAT(error("p=" + std::string(bad)), Says(quoted(bad), "empty value"));
}

TEST(Variants, TakeEachValueInItsOrder) {
  const std::vector<std::string> strides = {"3", "1", "2"};
  const SpecResult result = read_variants("flood", "stride", strides);
  ASSERT_EQ(result.contestants.size(), 3U);
  EXPECT_EQ(result.contestants[0].name, "flood");
  EXPECT_EQ(result.contestants[1].name, "flood:stride=1");
  EXPECT_EQ(result.contestants[2].settings.whole("stride"), 2);
}

TEST(Variants, OverrideTheSpec) {
  const std::vector<std::string> two = {"2", "02", "2.0"};
  const SpecResult result = read_variants("flood:stride=1", "stride", two);
  ASSERT_EQ(result.contestants.size(), 1U);
  EXPECT_EQ(result.contestants[0].name, "flood:stride=2");
}

std::string refusal(std::string_view spec, std::string_view parameter, const std::string& value) {
  const std::vector<std::string> list = {value};
  return read_variants(spec, parameter, list).error;
}

TEST(Variants, AreRefusedAsASpecIs) {
  EXPECT_THAT(refusal("flod", "stride", "1"), Says("'flod'", "'flood'"));
  EXPECT_THAT(refusal("flood", "strid", "1"), Says("'strid'", "'stride'"));
  EXPECT_THAT(refusal("flood", "stride", "9"), Says("'9'", "'stride'", "'flood'", "1 to 8", "is 8"));
  EXPECT_THAT(refusal("flood", "stride", "1.5"), Says("'1.5'", "'stride'", "whole number"));
  EXPECT_THAT(refusal("flood,certify", "stride", "1"), Says("'flood,certify'", "2 mice"));
  EXPECT_THAT(refusal("oracle", "stride", "1"), Says("oracle", "no parameters"));
}

TEST(Variants, OfAExternalStandInItsCommand) {
  const std::vector<std::string> values = {"4", "04", "4"};
  const SpecResult result = read_variants("program:sh -c 'x={a}; y={a}{b}'", "a", values);
  ASSERT_EQ(result.contestants.size(), 2U) << result.error;
  EXPECT_EQ(result.contestants[0].name, "program:sh -c 'x=4; y=4{b}'");
  EXPECT_EQ(result.contestants[1].name, "program:sh -c 'x=04; y=04{b}'");
  EXPECT_EQ(std::get<MmsProgram>(read_variants("mms:sh -c {a}", "a", values).contestants[0].kind).launch.words,
            (std::vector<std::string>{"sh", "-c", "4"}));
  ExternalOptions options;
  options.runs = 7;
  EXPECT_EQ(read_variants("program:sh {a}", "a", values, options).contestants[0].runs, 7);
  EXPECT_THAT(refusal("program:sh -c {b}", "a", "1"), Says("'program:sh -c {b}'", "{a}"));
  EXPECT_THAT(refusal("program:{a}", "a", "./nothing"), Says("no file", "'./nothing'"));
  EXPECT_EQ(read_variants("program:sh {a}", "a", std::vector<std::string>{"{a}{a}"}).contestants[0].name,
            "program:sh {a}{a}");
}

Sweep sweep(std::string_view spec, std::string_view vary, const std::vector<NamedMaze>& mazes,
            const RaceOrder& order = test::in_steps()) {
  return hold_sweep(spec, read_swept_values(vary), mazes, order);
}

/// All that a sweep found.
std::string digest(const Sweep& sweep) { return csv_of(sweep); }

TEST(Sweep, FindsAtEachValueWhatARaceFinds) {
  const std::vector<NamedMaze> mazes = {test::corridor(), test::loop(), test::without_route()};
  const Sweep found = sweep("flood", "stride=1:3:1", mazes);
  ASSERT_EQ(found.points.size(), 3U);
  for (const SweepPoint& point : found.points) {
    const Race race = hold_race(test::mice("flood:stride=" + point.value), mazes, test::in_steps());
    const Standing standing = standings_of(race).front();
    EXPECT_EQ(point.mean, standing.mean_all);
    EXPECT_EQ(point.interval, standing.interval);
    EXPECT_EQ(point.runs, 2);
    EXPECT_EQ(point.failures, 0);
  }
  EXPECT_EQ(found.mouse, "flood");
  EXPECT_EQ(found.routeless, 1);
  EXPECT_THAT(found.mazes, ElementsAre("corridor", "loop"));
}

TEST(Sweep, NamesTheMouseWithoutTheParameter) {
  EXPECT_EQ(sweep("flood:stride=1", "stride=2", {test::corridor()}).mouse, "flood");
}

TEST(Sweep, CountsAFailureAsTheRulesSay) {
  Rules rules;
  rules.budget = 15;  // enough for the corridor, and too little for a flood of the loop
  const Sweep found = sweep("flood", "stride=1", {test::corridor(), test::loop()}, test::in_steps(rules));
  EXPECT_EQ(found.points[0].failures, 1);
  EXPECT_EQ(found.points[0].runs, 2);
  EXPECT_GT(found.points[0].mean.value(), 50.0);
}

TEST(Sweep, InOneMazeHasItsIntervalOverTheRuns) {
  RaceOrder order = test::in_steps();
  order.runs = 8;
  const SweepPoint point = sweep("random", "stride=2", {test::loop(), test::without_route()}, order).points.front();
  ASSERT_TRUE(point.interval.has_value());
  EXPECT_EQ(point.runs, 8);
  EXPECT_LT(point.interval->low, *point.mean);
  EXPECT_GT(point.interval->high, *point.mean);
}

TEST(Sweep, OfOneContestHasNoInterval) {
  EXPECT_EQ(sweep("flood", "stride=2", {test::loop()}).points.front().interval, std::nullopt);
}

TEST(Sweep, WithoutARouteHasNoMeans) {
  const Sweep found = sweep("flood", "stride=1,2", {test::without_route()});
  EXPECT_EQ(found.points[1].mean, std::nullopt);
  EXPECT_EQ(found.points[1].runs, 0);
  EXPECT_THAT(table_of(found, false), Says("Left out", "1 maze whose goal"));
  EXPECT_EQ(XmlScanner(picture_of(found)).complaint(), "");
}

TEST(Sweep, DoesNotDependOnTheNumberOfThreads) {
  RaceOrder order = test::in_steps();
  order.jobs = 1;
  const std::string alone = digest(sweep("random", "stride=1:3:1", {test::loop(), test::corridor()}, order));
  for (const int jobs : {0, 2, 5}) {
    order.jobs = jobs;
    EXPECT_EQ(digest(sweep("random", "stride=1:3:1", {test::loop(), test::corridor()}, order)), alone) << jobs;
  }
  order.seed = 2;
  EXPECT_NE(digest(sweep("random", "stride=1:3:1", {test::loop(), test::corridor()}, order)), alone);
}

TEST(Sweep, GivesTheReasonOfARefusalAndRacesNothing) {
  for (const char* vary : {"strid=1", "stride=1:2", "stride=1,9"}) {
    const Sweep refused = sweep("flood", vary, {test::loop()});
    EXPECT_NE(refused.error, "") << vary;
    EXPECT_THAT(refused.points, IsEmpty());
  }
}

TEST(Sweep, LeavesOutTheValueAtWhichItIsStopped) {
  std::atomic<bool> stop = false;
  int told = 0;
  SweepHooks hooks;
  hooks.stop = &stop;
  hooks.finished = [&](std::size_t all) {
    EXPECT_EQ(all, 3U * 2U);
    stop = ++told == 3;
  };
  RaceOrder order = test::in_steps();
  order.jobs = 1;
  const Sweep found =
      hold_sweep("flood", read_swept_values("stride=1:3:1"), {test::loop(), test::corridor()}, order, hooks);
  EXPECT_EQ(told, 3);
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_EQ(found.points[0].value, "1");
  EXPECT_THAT(table_of(found, false), Says("Stopped", "1 of 3 values"));
}

/// Made up: one value that fails, one without an interval, and a tie.
Sweep made_up() {
  Sweep sweep;
  sweep.order = test::in_steps();
  sweep.mouse = "cautious";
  sweep.parameter = "share";
  sweep.meaning = "of the cells";
  sweep.mazes = {"here/one", "two"};
  sweep.values = 3;
  sweep.points = {{"0", 4, 1, 30.5, Interval{20.25, 40.0}, 30.0},
                  {"0.5", 4, 0, 20.0, std::nullopt},
                  {"1", 4, 0, 20.0, Interval{15.0, 25.0}}};
  return sweep;
}

TEST(SweepAsTable, HasALineForEachValue) {
  const std::string table = table_of(made_up(), false);
  EXPECT_THAT(table, HasSubstr("\nshare     mean    95 % interval  failed  contests\n"
                               "    0   30.500    20.250-40.000       1         4\n"
                               "  0.5   20.000                -       0         4\n"));
  EXPECT_THAT(table, HasSubstr("over the 2 mazes"));
  EXPECT_THAT(table, Says("Lowest mean", "20.000 at share=0.5", "1 other"));
  EXPECT_THAT(table, Not(HasSubstr("\x1b")));
  EXPECT_THAT(table, Not(HasSubstr("Stopped")));
  EXPECT_THAT(table_of(made_up(), true), HasSubstr("\x1b[1m"));
}

TEST(SweepAsCsv, LeavesEmptyWhatIsNotThere) {
  EXPECT_EQ(csv_of(made_up()),
            "value,mean,low,high,failures,runs\n0,30.5,20.25,40,1,4\n0.5,20,,,0,4\n1,20,15,25,0,4\n");
}

TEST(SweepAsPicture, ShowsEachPointWithItsInterval) {
  const std::string svg = picture_of(made_up());
  EXPECT_EQ(XmlScanner(svg).complaint(), "");
  EXPECT_EQ(count(svg, "<circle"), 3 + 2);           // and two in the legend: with and without failures
  EXPECT_EQ(count(svg, "stroke-muted"), 2 + 1 + 1);  // whiskers, the legend's, and the style sheet
  EXPECT_THAT(svg,
              HasSubstr("<title>share=0: mean 30.500, 95 % interval 20.250 to 40.000, 1 of 4 contests failed</title>"));
  EXPECT_THAT(svg, HasSubstr(">share: of the cells<"));
  EXPECT_THAT(svg, HasSubstr(">mean score (steps; lower is better)<"));
  EXPECT_THAT(svg, HasSubstr(">95 % interval over the 2 mazes<"));
  EXPECT_THAT(svg, HasSubstr(">mean of 4 contests, failures counted 100<"));
  EXPECT_THAT(svg, HasSubstr("@media (prefers-color-scheme:dark)"));
}

TEST(SweepAsPicture, SaysWhereValuesCountDifferentContests) {
  Sweep sweep = made_up();
  sweep.points[2].runs = 1;
  EXPECT_THAT(picture_of(sweep), HasSubstr(">mean of 1 to 4 contests<"));
}

TEST(SweepAsPicture, IsWellFormedForNamesAndForNothing) {
  Sweep sweep = made_up();
  sweep.mouse = "a<b>&\"c\"\x1b";
  sweep.points[1].value = "left-ahead-right<&>";
  EXPECT_EQ(XmlScanner(picture_of(sweep)).complaint(), "");
  sweep.points.resize(1);
  EXPECT_EQ(XmlScanner(picture_of(sweep)).complaint(), "");
  sweep.points.clear();
  EXPECT_EQ(XmlScanner(picture_of(sweep)).complaint(), "");
}

Entry entry_in(std::string_view world, const WorldSettings& settings = {}, const char* mouse = "flood-return") {
  EntriesResult entered = enter(test::mice(mouse), world, settings);
  EXPECT_EQ(entered.error, "");
  return std::move(entered.entries.front());
}

RobotVariants variants_in(const Entry& entry, std::string_view vary) {
  const SweptValues swept = read_swept_values(vary);
  return robot_variants(entry, swept.parameter, swept.values);
}

/// The parameters of the robot and the hash of its tables, as the world's conditions have them.
std::pair<Json, Json> robot_of(const World& world) {
  const Json conditions = conditions_json(world);
  return {conditions["robot"]["parameters"], conditions["tables"]};
}

TEST(RobotVariants, DifferInOneValue) {
  const Entry entry = entry_in("seconds", {{"robot", "half"}, {"rules", "uk"}});
  const RobotVariants made = variants_in(entry, "straight.acceleration=2e3,4200,2000");
  EXPECT_EQ(made.error, "");
  EXPECT_THAT(made.values, ElementsAre("2000", "4200"));
  EXPECT_EQ(made.robot, "half");
  EXPECT_THAT(made.meaning, HasSubstr("mm/s²"));
  EXPECT_THAT(made.remarks, IsEmpty());
  const auto [usual, tables] = robot_of(*entry.world);
  EXPECT_EQ(robot_of(*made.worlds.at(1)), std::pair(usual, tables)) << "the value of the file itself";
  Json expected = usual;
  expected["straight.acceleration"] = 2000.0;
  EXPECT_EQ(robot_of(*made.worlds.at(0)).first, expected);
  EXPECT_NE(robot_of(*made.worlds.at(0)).second, tables);
  EXPECT_EQ(conditions_json(*made.worlds.at(0))["rules"]["name"], "uk");
}

TEST(RobotVariants, TakeAllThatARobotFileTakes) {
  const RobotVariants diagonals = variants_in(entry_in("seconds"), "diagonals=true,false");
  ASSERT_EQ(diagonals.error, "");
  EXPECT_TRUE(robot_of(*diagonals.worlds.at(0)).first.contains("diagonal.speed"));
  EXPECT_FALSE(robot_of(*diagonals.worlds.at(1)).first.contains("diagonal.speed"));
  EXPECT_EQ(robot_of(*variants_in(entry_in("seconds"), "stop=goal,beyond").worlds.at(1)).first.count("stop"), 0);
  EXPECT_EQ(robot_of(*variants_in(entry_in("seconds"), "sight=1,3").worlds.at(1)).first["sight"], 3);
  EXPECT_EQ(robot_of(*variants_in(entry_in("seconds"), "layout.V90=false").worlds.at(0)).first["layout.V90"], false);
  // 45 and 60 degrees.
  const RobotVariants angles = variants_in(entry_in("physical"), "sensors.side_angle=0.7854,1.0472");
  EXPECT_EQ(angles.error, "");
  EXPECT_EQ(robot_of(*angles.worlds.at(0)).first["sensors.side_angle"], 0.7854);
}

TEST(RobotVariants, HaveTheRemarksThatTheRobotItselfHasNot) {
  EXPECT_THAT(variants_in(entry_in("seconds"), "search.pivot_speed=10,90").remarks,
              ElementsAre(Says("search.pivot_speed=90", "degrees")));
  EXPECT_THAT(variants_in(entry_in("seconds"), "clearance=45,0.04").remarks, ElementsAre(Says("clearance=0.04")));
}

TEST(RobotVariants, AreRefusedAsRobotFilesAre) {
  const auto error = [](const Entry& entry, std::string_view vary) {
    const RobotVariants made = variants_in(entry, vary);
    EXPECT_THAT(made.worlds.empty(), !made.error.empty());
    EXPECT_THAT(made.error, StartsWith("error: --robot-number "));
    EXPECT_THAT(made.error, Not(HasSubstr("\n")));
    return made.error;
  };
  const Entry seconds = entry_in("seconds");
  EXPECT_THAT(error(seconds, "straight.acceleration=3000,5"),
              Says("straight.acceleration=5", "'straight.acceleration'", "100 to 200000 mm/s²"));
  EXPECT_THAT(error(seconds, "sight=1.5"), Says("sight=1.5", "whole number"));
  EXPECT_THAT(error(seconds, "sight=far"), Says("sight=far", "number"));
  EXPECT_THAT(error(seconds, "diagonals=1"), Says("diagonals=1", "true or false"));
  EXPECT_THAT(error(seconds, "clearance=89"), Says("clearance=89"));
  EXPECT_THAT(error(seconds, "acceleration=3000"), Says("'acceleration'", "'straight.acceleration'"));
  EXPECT_THAT(error(seconds, "search.cell=300"), Says("search.cell"));
  EXPECT_THAT(error(seconds, "motors.drive_gain=3000"), Says("'motors.drive_gain'", "seconds"));
  EXPECT_THAT(error(entry_in("failures"), "straight.acceleration=3000"), Says("failures", "--world physical"));
  EXPECT_THAT(error(entry_in("steps"), "straight.acceleration=3000"),
              testing::AllOf(Says("steps", "--world seconds"), Not(HasSubstr("--world failures"))));
}

TEST(RobotSweep, FindsWhatRacesOfTheseRobotsFind) {
  LABMOUSE_SKIP_SANITIZED();
  const std::vector<NamedMaze> mazes = {test::corridor(), test::loop()};
  for (const auto& [world, vary] : {std::pair("seconds", "straight.acceleration=5000,10000,20000"),
                                    std::pair("physical", "motors.drive_gain=2000,4000,6000")}) {
    const Entry entry = entry_in(world);
    RaceOrder order;
    order.world = entry.world;
    order.runs = 2;
    const RobotVariants robots = variants_in(entry, vary);
    const Sweep found = hold_robot_sweep(entry.mice.front(), robots, mazes, order);
    ASSERT_EQ(found.points.size(), 3U) << found.error;
    std::vector<Race> races;
    for (std::size_t i = 0; i < 3; ++i) {
      order.world = robots.worlds[i];
      races.push_back(hold_race(entry.mice, mazes, order));
      const Standing standing = standings_of(races.back()).front();
      EXPECT_EQ(found.points[i].mean, standing.mean_at_limit);
      ASSERT_EQ(found.points[i].against_first.has_value(), i > 0);
      if (i == 0) continue;
      const PairedDifference& difference = found.points[i].against_first->scores;
      EXPECT_EQ(difference.count, 2);
      EXPECT_NEAR(difference.mean, *found.points[i].mean - *found.points[0].mean, 1e-9);
      EXPECT_THAT(compare_robots(races), HasSubstr(fmt::format(" {:+.3f} ", difference.mean + 0.0)));
      EXPECT_THAT(table_of(found, false), HasSubstr(fmt::format(" {:+.3f} ", difference.mean + 0.0)));
    }
    EXPECT_NE(found.points[2].against_first->scores.mean, 0.0) << world;
  }
}

TEST(RobotSweep, HasItsDifferencesInJsonAndCsv) {
  const Entry entry = entry_in("seconds");
  RaceOrder order;
  order.world = entry.world;
  const Sweep found = hold_robot_sweep(entry.mice.front(), variants_in(entry, "straight.acceleration=2000,4000"),
                                       {test::corridor(), test::loop(), test::without_route()}, order);
  const Json json = Json::parse(json_of(found));
  EXPECT_EQ(json["robot"], "classic");
  EXPECT_EQ(json["parameter"], "straight.acceleration");
  EXPECT_EQ(json["conditions"]["robot"]["name"], "classic");
  EXPECT_EQ(json["mazes"], Json({"corridor", "loop"}));
  EXPECT_EQ(json["routeless"], 1);
  EXPECT_EQ(json["stopped"], false);
  ASSERT_EQ(json["values"].size(), 2U);
  EXPECT_EQ(json["values"][0]["difference"], nullptr);
  const Json& second = json["values"][1];
  const PairedDifference& difference = found.points[1].against_first->scores;
  EXPECT_EQ(second["mean"], *found.points[1].mean);
  EXPECT_EQ(second["difference"]["mean_difference"], difference.mean);
  EXPECT_EQ(second["difference"]["interval"], Json({difference.interval.low, difference.interval.high}));
  EXPECT_EQ(second["difference"]["mazes"], 2);
  std::istringstream csv(csv_of(found));
  std::string header, first, line;
  std::getline(std::getline(std::getline(csv, header), first), line);
  EXPECT_THAT(header, testing::EndsWith(",difference,difference_low,difference_high,verdict"));
  EXPECT_THAT(first, testing::EndsWith(",,,,"));
  EXPECT_THAT(line,
              HasSubstr(fmt::format(",{},{},{},", difference.mean, difference.interval.low, difference.interval.high)));
  EXPECT_EQ(std::count(line.begin(), line.end(), ','), std::count(header.begin(), header.end(), ','));
}

TEST(Sweep, OfAParameterHasNoRobotInJson) {
  const Json json = Json::parse(json_of(made_up()));
  EXPECT_FALSE(json.contains("robot"));
  EXPECT_FALSE(json["values"][0].contains("difference"));
  EXPECT_EQ(json["values"][0]["interval"], Json({20.25, 40.0}));
  EXPECT_EQ(json["values"][1]["interval"], nullptr);
  EXPECT_EQ(json["values"][0]["finished_mean"], 30.0);
  EXPECT_EQ(json["values"][0]["failed"], 1);
  EXPECT_EQ(json["values"][0]["contests"], 4);
}

}  // namespace
}  // namespace labmouse
