#include "labmouse/lab/steps/steps_world.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::json;
using test::Says;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

std::vector<std::string> keys(const Json& json) {
  std::vector<std::string> list;
  for (const auto& item : json.items()) list.push_back(item.key());
  return list;
}

/// A race as JSON, read back.
class RaceAsJson : public testing::Test {
 protected:
  const Json& maze(int i) const { return json_.at("groups").at(0).at("mazes").at(static_cast<std::size_t>(i)); }
  const Json& mouse(std::string_view name) const {
    for (const Json& mouse : json_.at("groups").at(0).at("mice"))
      if (mouse.at("name") == name) return mouse;
    throw std::runtime_error("no such mouse");
  }
  const Json& result(std::string_view mouse_name, std::string_view maze) const {
    for (const Json& result : mouse(mouse_name).at("results"))
      if (result.at("maze") == maze) return result;
    throw std::runtime_error("no such result");
  }

  Race race_ = test::race_of("flood:stride=1,random");
  Json json_ = Json::parse(json_of(race_, {{"bad.txt", {{2, 5, "is odd"}, {0, 0, "is bad"}}}}));
};

TEST_F(RaceAsJson, NamesItsVersion) { EXPECT_EQ(json_.at("labmouse"), version()); }

TEST_F(RaceAsJson, HasAllFieldsOfAMaze) {
  EXPECT_THAT(keys(maze(0)), UnorderedElementsAre("name", "width", "height", "optimum", "bound"));
}

TEST_F(RaceAsJson, HasAllFieldsOfAMouse) {
  EXPECT_THAT(keys(mouse("random")), IsSupersetOf({"name", "parameters", "finished", "runs", "mean_score", "mean_par1",
                                                   "interval", "mean_ratio", "results"}));
}

TEST_F(RaceAsJson, HasAllFieldsOfAResult) {
  EXPECT_THAT(keys(result("random", "loop")),
              UnorderedElementsAre("maze", "seed", "outcome", "score", "search_steps", "speed_steps",
                                   "discovered_share", "visited_share", "microseconds_per_decision"));
}

TEST_F(RaceAsJson, ListsMazesInTheOrderOfTheirNames) {
  EXPECT_EQ(maze(0).at("name"), "corridor");
  EXPECT_EQ(maze(1).at("name"), "loop");
  EXPECT_EQ(maze(2).at("name"), "without-route");
}

TEST_F(RaceAsJson, AMazeHasItsSizeAndLimits) {
  EXPECT_EQ(maze(0).at("width"), 4);
  EXPECT_EQ(maze(0).at("height"), 2);
  EXPECT_EQ(maze(0).at("optimum"), 3);
  EXPECT_DOUBLE_EQ(maze(0).at("bound"), 3 + 4 / 30.0);
}

TEST_F(RaceAsJson, AMazeWithoutARouteHasNullLimits) {
  EXPECT_TRUE(maze(2).at("optimum").is_null());
  EXPECT_TRUE(maze(2).at("bound").is_null());
}

TEST_F(RaceAsJson, AFailedContestLacksItsScoreAndSpeedSteps) {
  const Json& failed = result("flood:stride=1", "without-route");
  EXPECT_EQ(failed.at("outcome"), "forfeit: no route");
  EXPECT_TRUE(failed.at("score").is_null());
  EXPECT_TRUE(failed.at("speed_steps").is_null());
}

TEST_F(RaceAsJson, AFinishedContestHasItsScore) {
  const Json& finished = result("flood:stride=1", "corridor");
  EXPECT_EQ(finished.at("outcome"), "finished");
  EXPECT_DOUBLE_EQ(finished.at("score"),
                   finished.at("speed_steps").get<int>() + finished.at("search_steps").get<int>() / 30.0);
}

TEST_F(RaceAsJson, SharesAreOfTheReachableCells) {
  EXPECT_DOUBLE_EQ(result("flood:stride=1", "corridor").at("visited_share"), 1.0);
  EXPECT_DOUBLE_EQ(result("flood:stride=1", "without-route").at("discovered_share"), 1.0);
  const Json& flood = mouse("flood:stride=1");
  const double loop = result("flood:stride=1", "loop").at("visited_share");
  EXPECT_LT(loop, 1.0);
  EXPECT_DOUBLE_EQ(flood.at("mean_visited_share"), (1.0 + loop) / 2);
  EXPECT_GE(flood.at("mean_discovered_share"), flood.at("mean_visited_share"));
}

TEST_F(RaceAsJson, ParametersAreNamesAndValues) {
  EXPECT_EQ(mouse("flood:stride=1").at("parameters"), Json({{"stride", 1}}));
}

TEST_F(RaceAsJson, TheIntervalIsLowAndHighOfThePenalisedMean) {
  const Json& interval = mouse("random").at("interval");
  ASSERT_EQ(interval.size(), 2U);
  EXPECT_LE(interval[0], mouse("random").at("mean_par1"));
  EXPECT_GE(interval[1], mouse("random").at("mean_par1"));
}

TEST_F(RaceAsJson, SeedsAreWholeNumbers) { EXPECT_TRUE(result("random", "loop").at("seed").is_number_unsigned()); }

TEST_F(RaceAsJson, ListsSkippedFilesWithTheReasons) {
  ASSERT_EQ(json_.at("skipped").size(), 1U);
  EXPECT_EQ(json_.at("skipped")[0].at("path"), "bad.txt");
  EXPECT_EQ(json_.at("skipped")[0].at("reasons"), Json({"bad.txt:2:5: error: is odd", "bad.txt: error: is bad"}));
}

TEST_F(RaceAsJson, HasTheNotesOfTheTable) {
  std::string notes;
  for (const Json& line : json_.at("groups").at(0).at("notes")) notes += line.get<std::string>() + "\n";
  EXPECT_THAT(notes, Not(IsEmpty()));
  EXPECT_THAT(table_of(race_, false), EndsWith("\n\n" + notes));
}

TEST(RaceAsJsonToo, AMouseWithoutARouteAnywhereHasNullMeans) {
  const Json json = Json::parse(json_of(hold_race(test::mice("flood"), {test::without_route()}, test::in_steps()), {}));
  for (const char* field :
       {"mean_score", "mean_par1", "interval", "mean_ratio", "mean_discovered_share", "mean_visited_share"})
    EXPECT_TRUE(json.at("groups").at(0).at("mice")[0].at(field).is_null()) << field;
  EXPECT_TRUE(json.at("skipped").empty());
}

TEST(RaceAsJsonToo, NamesThatAreNoUtf8DoNoHarm) {
  NamedMaze maze = test::corridor();
  maze.name = "caf\xe9.txt";
  EXPECT_TRUE(Json::accept(
      json_of(hold_race(test::mice("flood"), {maze}, test::in_steps()), {{"b\xff", {{0, 0, "is b\xff"}}}})));
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> list;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) list.push_back(line);
  return list;
}

TEST(RaceAsCsv, HasALineForEachContest) {
  const Race race = test::race_of("flood,certify");
  const auto list = lines(csv_of(race));
  ASSERT_EQ(list.size(), 1U + race.results.size());
  EXPECT_EQ(list[0],
            "mouse,maze,seed,outcome,score,search_steps,speed_steps,optimum,bound,microseconds_per_decision,"
            "discovered_share,visited_share");
  for (const std::string& line : list) EXPECT_EQ(std::count(line.begin(), line.end(), ','), 11);
  EXPECT_EQ(list[1].find("certify,corridor,"), 0U);
}

TEST(RaceAsCsv, EndsWithTheShares) {
  const auto list = lines(csv_of(hold_race(test::mice("oracle"), {test::hook()}, test::in_steps())));
  EXPECT_TRUE(list[1].ends_with(",0.75,0.5")) << list[1];
}

TEST(RaceAsCsv, LeavesEmptyWhatAFailedContestLacks) {
  const auto list = lines(csv_of(hold_race(test::mice("flood"), {test::without_route()}, test::in_steps())));
  EXPECT_THAT(list[1], HasSubstr(",forfeit: no route,,"));
  EXPECT_THAT(list[1], HasSubstr(",,,,"));
}

TEST(RaceAsCsv, QuotesNamesWithCommasAndQuotes) {
  NamedMaze maze = test::corridor();
  maze.name = "a \"big\", long one";
  EXPECT_THAT(csv_of(hold_race(test::mice("flood"), {maze}, test::in_steps())),
              HasSubstr(",\"a \"\"big\"\", long one\","));
}

TEST(RaceAsTable, ShowsEveryMouseBestFirst) {
  const std::string table = table_of(test::race_of("random,flood"), false);
  EXPECT_LT(table.find("\nflood "), table.find("\nrandom "));
  EXPECT_THAT(table, Says("Left out", "1 maze whose goal", "(without-route)"));
}

TEST(RaceAsTable, OneMazeHasNoInterval) {
  constexpr const char* interval = "[0-9]\\.[0-9]-[0-9]+\\.[0-9]";
  EXPECT_THAT(table_of(test::race_of("flood"), false), ::testing::ContainsRegex(interval));
  const Race race = hold_race(test::mice("flood"), {test::corridor()}, test::in_steps());
  EXPECT_THAT(table_of(race, false), ::testing::Not(::testing::ContainsRegex(interval)));
}

TEST(RaceAsTable, ColoursOnlyWhereAsked) {
  const Race race = test::race_of("flood");
  EXPECT_THAT(table_of(race, false), Not(HasSubstr("\x1b")));
  EXPECT_THAT(table_of(race, true), HasSubstr("\x1b["));
}

TEST(RaceAsTable, SaysWhereMeansOfFinishedContestsCoverDifferentMazes) {
  Rules rules;
  rules.budget = 15;  // too little for a flood of the loop
  const Race race = hold_race(test::mice("oracle,flood"), {test::loop(), test::corridor()}, test::in_steps(rules));
  EXPECT_THAT(table_of(race, false), HasSubstr("different mazes"));
  EXPECT_THAT(table_of(test::race_of("oracle,flood"), false), Not(HasSubstr("different mazes")));
}

TEST(RaceAsTable, MarksTheOracle) {
  EXPECT_THAT(table_of(test::race_of("oracle,flood"), false), HasSubstr("oracle *"));
}

TEST(Shares, ArePercentInTheOrderOfTheLeaderboard) {
  const Race race = hold_race(test::mice("oracle,flood"), {test::loop(), test::without_route()}, test::in_steps());
  const auto list = lines(shares_of(race));
  ASSERT_EQ(list.size(), 4U);
  EXPECT_EQ(list[2].find("oracle *"), 0U);
  EXPECT_EQ(list[3].find("flood "), 0U);
  EXPECT_THAT(shares_of(hold_race(test::mice("oracle"), {test::hook(), test::without_route()}, test::in_steps())),
              HasSubstr("\noracle *        75.0     50.0\n"));
  EXPECT_THAT(shares_of(hold_race(test::mice("flood"), {test::without_route()}, test::in_steps())),
              HasSubstr("flood           -        -"));
}

TEST(Worst, ListsTheCostliestMazesFirst) {
  const std::string text = worst_of(test::race_of("flood"), 1);
  EXPECT_THAT(text, HasSubstr("loop"));
  EXPECT_THAT(text, Not(HasSubstr("corridor")));
}

TEST(Worst, CountsFromTheBound) {
  EXPECT_THAT(worst_of(hold_race(test::mice("oracle"), {test::corridor()}, test::in_steps()), 5),
              HasSubstr("3.133 = bound 3.133 + 0.000"));
}

Standing standing_of(const Race& race, std::string_view mouse) {
  for (const Standing& standing : standings_of(race))
    if (race.mice[standing.mouse].name == mouse) return standing;
  ADD_FAILURE() << "no standing of " << mouse;
  return {};
}

double figure(const Race& race, std::string_view mouse, std::string_view key) {
  return number_of(figure_of(race, standing_of(race, mouse), key)).value();
}

TEST(Standings, LeaveMazesWithoutARouteOut) {
  const Race race = test::race_of("flood");
  const Standing standing = standing_of(race, "flood");
  EXPECT_EQ(race.results.size(), 3U);
  EXPECT_EQ(standing.runs, 2);
  EXPECT_EQ(standing.finished, 2);
  EXPECT_EQ(standing.mean_all, standing.mean_finished);
}

TEST(Standings, WithoutAnyRouteHaveNoMeans) {
  const Race race = hold_race(test::mice("flood"), {test::without_route()}, test::in_steps());
  const Standing standing = standing_of(race, "flood");
  EXPECT_EQ(standing.runs, 0);
  EXPECT_EQ(standing.mean_finished, std::nullopt);
  EXPECT_EQ(standing.mean_all, std::nullopt);
}

TEST(Standings, OfTheOracleAreTheBound) {
  const Race race = test::race_of("oracle");
  EXPECT_DOUBLE_EQ(standing_of(race, "oracle").mean_ratio.value(), 1.0);
  EXPECT_DOUBLE_EQ(figure(race, "oracle", "mean_speed_over_optimum"), 0.0);
  EXPECT_DOUBLE_EQ(figure(race, "oracle", "optimal_share"), 1.0);
}

/// A race made up: two mice in two mazes, the second maze unfinished by the first mouse.
Race made_up() {
  Race race;
  race.order = test::in_steps();
  race.mice = test::mice("certify,flood");
  race.mazes = {test::corridor(), test::loop()};
  race.facts = {{3.0, 3.0, {}}, {8.0, 4.0, {}}};
  const auto add = [&](std::size_t mouse, std::size_t maze, std::int64_t search_run, std::int64_t speed,
                       std::optional<double> score) {
    ContestResult result;
    result.mouse = mouse;
    result.maze = maze;
    result.done = true;
    result.outcome = score ? "finished" : "out of steps";
    result.score = score;
    result.counted = score.value_or(100);
    if (score) result.ratio = *score / *race.facts[maze].bound;
    const auto figures = std::make_shared<StepsFigures>();
    figures->search_steps = search_run;
    figures->speed_steps = speed;
    figures->decisions = search_run + speed;
    figures->microseconds = {2.0 * static_cast<double>(figures->decisions)};
    result.figures = figures;
    race.results.push_back(result);
  };
  add(0, 0, 30, 3, 4.0);
  add(0, 1, 1000, 0, {});
  add(1, 0, 60, 4, 6.0);
  add(1, 1, 120, 4, 8.0);
  return race;
}

TEST(Standings, CountAFailureAsAHundred) {
  const Standing standing = standing_of(made_up(), "certify");
  EXPECT_EQ(standing.finished, 1);
  EXPECT_DOUBLE_EQ(standing.mean_finished.value(), 4.0);
  EXPECT_DOUBLE_EQ(standing.mean_all.value(), 52.0);
  EXPECT_DOUBLE_EQ(standing.mean_share.value(), 3.0 / 4.0 / 2);
}

TEST(Standings, HaveNoShareOfTheBestWhereScoresHaveNoRatio) {
  Race race = made_up();
  EXPECT_EQ(share_of_best(race, race.results[1]), 0.0);
  race.order.world = find_world("seconds")->make({{"rules", "coverage"}}).world;
  EXPECT_EQ(share_of_best(race, race.results[1]), std::nullopt);
}

TEST(Standings, AreSortedByTheMeanOverAll) {
  const Race race = made_up();
  const auto standings = standings_of(race);
  EXPECT_EQ(race.mice[standings[0].mouse].name, "flood");
  EXPECT_EQ(race.mice[standings[1].mouse].name, "certify");
}

TEST(Standings, CountWhatTheTableShows) {
  const Standing standing = standing_of(made_up(), "flood");
  EXPECT_DOUBLE_EQ(standing.mean_ratio.value(), (6.0 / 3.0 + 8.0 / 8.0) / 2);
  EXPECT_DOUBLE_EQ(standing.mean_share.value(), (3.0 / 6.0 + 8.0 / 8.0) / 2);
  EXPECT_DOUBLE_EQ(figure(made_up(), "flood", "mean_search_steps"), 90.0);
  EXPECT_DOUBLE_EQ(figure(made_up(), "flood", "mean_speed_over_optimum"), 0.5);
  EXPECT_DOUBLE_EQ(figure(made_up(), "flood", "optimal_share"), 0.5);
  EXPECT_DOUBLE_EQ(figure(made_up(), "flood", "microseconds_per_decision"), 2.0);
}

TEST(Standings, TheShareOfOptimalRunsIsOfAllContests) {
  EXPECT_DOUBLE_EQ(figure(made_up(), "certify", "optimal_share"), 0.5);
}

TEST(Standings, TheIntervalHoldsTheMean) {
  const Standing standing = standing_of(made_up(), "flood");
  EXPECT_LE(standing.interval.low, 7.0);
  EXPECT_GE(standing.interval.high, 7.0);
}

TEST(Standings, ContestsThatWereNotHeldCountNothing) {
  Race race = made_up();
  race.results[1].done = false;
  EXPECT_DOUBLE_EQ(standing_of(race, "certify").mean_all.value(), 4.0);
}

}  // namespace
}  // namespace labmouse
