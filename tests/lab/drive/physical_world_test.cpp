#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "labmouse/lab/drive/drive_entries.hpp"
#include "labmouse/lab/drive/drive_worlds.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/numbers/maze_interval.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/worlds/entering.hpp"
#include "tests/lab/drive/physical_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::at_errors;
using test::Says;
using ::testing::HasSubstr;
using ::testing::Not;

using F = PhysicalFigures;

PhysicalConditions rough() {
  PhysicalConditions conditions = at_errors(5.0);
  conditions.errors.variation = 2.0;
  return conditions;
}

Race race_at(const PhysicalConditions& conditions, int runs, const std::string& mice = "flood-return") {
  RaceOrder order;
  order.world = physical_world(find_rules("all-japan").rules, test::drive_model("kerise"), conditions);
  order.runs = runs;
  return hold_race(read_specs(mice).contestants, {{"ring", test::ring()}}, order);
}

template <class Member>
double number(const ContestResult& result, Member figure) {
  return number_of(value_of(figures_of<F>(result).*figure)).value_or(0.0);
}

TEST(PhysicalWorld, HoldsEachContestWithDiceOfItsOwn) {
  const Race race = race_at(at_errors(0.5), 4);
  ASSERT_EQ(race.results.size(), 4U);
  EXPECT_NE(race.results[0].score, race.results[1].score);
  for (const ContestResult& result : race.results) {
    const PhysicalRecord record = test::driven_physically("flood-return", test::ring(), at_errors(0.5), result.seed);
    EXPECT_DOUBLE_EQ(*result.score, in_seconds(*score(record.drive, find_rules("all-japan").rules).value()));
    EXPECT_EQ(number(result, &F::severity), record.severity);
    EXPECT_EQ(number(result, &F::wrong_walls), record.wrong_walls);
  }
}

TEST(PhysicalWorld, CountsWhatEndedRuns) {
  const Race race = race_at(rough(), 60);
  int crashed = 0, unscored = 0;
  for (const ContestResult& result : race.results) {
    const double ends = number(result, &F::slid) + number(result, &F::position_lost) + number(result, &F::wall_error);
    crashed += ends > 0;
    EXPECT_GE(number(result, &F::carried) + 1, ends);
    EXPECT_LE(number(result, &F::done), number(result, &F::starts));
    unscored += !result.score;
    // Only the column that says so counts failures.
    EXPECT_EQ(number(result, &F::par1), result.score.value_or(300.0));
  }
  EXPECT_GT(crashed, 0);
  ASSERT_GT(unscored, 0);
  const Standing standing = standings_of(race).front();
  EXPECT_EQ(standing.finished, 60 - unscored);
  const auto json = nlohmann::json::parse(json_of(race, {})).at("groups").at(0).at("mice").at(0);
  std::vector<MazeSum> sums(race.mazes.size());
  for (const ContestResult& result : race.results) {
    sums[result.maze].count += 1.0;
    sums[result.maze].sum += result.score ? 1.0 : 0.0;
  }
  const Interval interval = share_interval(sums);
  EXPECT_NEAR(json.at("finished_interval").at(0).get<double>(), interval.low, 1e-9);
  EXPECT_NEAR(json.at("finished_interval").at(1).get<double>(), interval.high, 1e-9);
  double scored = 0.0, all = 0.0;
  for (const ContestResult& result : race.results) {
    scored += result.score.value_or(0.0);
    all += result.score.value_or(300.0);
  }
  EXPECT_NEAR(json.at("mean_score").get<double>(), scored / (60 - unscored), 1e-9);
  EXPECT_NEAR(json.at("mean_par1").get<double>(), all / 60.0, 1e-9);
  EXPECT_THAT(table_of(race, false), Says("at limit", "no route", "wall", "slipped", "position"));
}

TEST(PhysicalWorld, IsMadeOfWhatItIsToldAndMadeAgainOfItsConditions) {
  const WorldResult made = physical_entry.make({{"noise", "2.5"}, {"variation", "1.5"}, {"search-speed", "330"}});
  ASSERT_TRUE(made.world) << made.error;
  RaceOrder order;
  order.world = made.world;
  const auto json =
      nlohmann::json::parse(json_of(hold_race(read_specs("flood").contestants, {{"ring", test::ring()}}, order), {}));
  const auto& group = json.at("groups").at(0);
  EXPECT_EQ(group.at("noise"), 2.5);
  EXPECT_EQ(group.at("variation"), 1.5);
  EXPECT_EQ(group.at("search_speed"), 330.0);
  EXPECT_TRUE(group.at("robot").at("parameters").contains("body.front"));
}

TEST(PhysicalWorld, IsAsFarSpreadAsTheFieldUnlessTold) {
  EXPECT_EQ(PhysicalConditions{}.errors.variation, 1.0);
  const WorldResult made = physical_entry.make({});
  ASSERT_TRUE(made.world) << made.error;
  const auto conditions = made.world->traits().conditions;
  const auto variation =
      std::find_if(conditions.begin(), conditions.end(), [](const Condition& each) { return each.key == "variation"; });
  ASSERT_NE(variation, conditions.end());
  EXPECT_EQ(variation->value, Value(1.0));
}

TEST(PhysicalWorld, RefusesWhatItCannotUse) {
  for (const auto& [name, value] : {std::pair("noise", "much"),
                                    {"noise", "-1"},
                                    {"noise", "nan"},
                                    {"variation", "11"},
                                    {"search-speed", ""},
                                    {"noise", "1e3"}}) {
    const WorldResult result = physical_entry.make({{name, value}});
    EXPECT_FALSE(result.world) << name << value;
    EXPECT_THAT(result.error, HasSubstr(std::string("--") + name));
  }
  // Robots without a body, and those whose turns are times.
  EXPECT_THAT(physical_entry.make({{"robot", "mm2021"}}).error, Says("mm2021", "[body]"));
  EXPECT_THAT(physical_entry.make({{"robot", "nowhere"}}).error, HasSubstr("nowhere"));
}

TEST(PhysicalWorld, HasThreeContestsInAMazeUnlessTold) {
  EXPECT_EQ(race_at(at_errors(1.0), physical_entry.usual_runs).results.size(), 3U);
}

}  // namespace
}  // namespace labmouse
