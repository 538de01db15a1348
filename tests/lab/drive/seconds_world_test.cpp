#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "labmouse/lab/bounds/drive_bound.hpp"
#include "labmouse/lab/drive/drive_results.hpp"
#include "labmouse/lab/drive/drive_worlds.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/worlds/entering.hpp"
#include "tests/lab/records/drive_record_fixture.hpp"
#include "tests/says.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

using F = SecondsFigures;

DriveRules rules_called(const std::string& name) { return find_rules(name).rules; }

RaceOrder order(const DriveRules& rules = rules_called("all-japan")) {
  RaceOrder order;
  order.world = seconds_world(rules, test::drive_model("mm2021"));
  order.jobs = 1;
  return order;
}

std::vector<Contestant> mice(const std::string& specs) { return read_specs(specs).contestants; }

template <class Struct, class Member>
std::optional<double> number(const ContestResult& result, Member Struct::*figure) {
  return number_of(value_of(figures_of<F>(result).*figure));
}
std::optional<double> fastest(const Race& race, std::size_t maze) { return race.facts[maze].best_run; }
/// A figure of a mouse in JSON.
std::optional<double> number(const Race& race, const Standing& standing, std::string_view key) {
  return number_of(figure_of(race, standing, key));
}

std::vector<NamedMaze> some_mazes() {
  std::vector<NamedMaze> mazes = {{"ring", test::ring()}};
  Rng rng(11);
  for (int i = 0; i < 6; ++i) {
    const Maze maze = test::any_maze(rng, 8);
    mazes.push_back(
        {"maze " + std::to_string(i), maze.with_start({0, 0}, Heading::north).with_goals(centre_of(maze.size()))});
  }
  mazes.push_back({"closed", Maze(MazeDraft({3, 3}, MazeDraft::Inside::closed))});
  return mazes;
}

TEST(SecondsWorld, HoldsContestsWhereAMouseCouldScore) {
  const Race race = hold_race(mice("flood,certify"), some_mazes(), order());
  EXPECT_FALSE(race.stopped);
  ASSERT_EQ(race.results.size(), 2 * race.mazes.size());
  for (const ContestResult& result : race.results) {
    EXPECT_TRUE(result.done);
    if (race.mazes[result.maze].name != "closed") continue;
    EXPECT_FALSE(fastest(race, result.maze));
    EXPECT_FALSE(counts(race, result));
  }
}

TEST(SecondsWorld, SumsUpAContest) {
  const RaceOrder ordered = order();
  const Race race = hold_race(mice("flood"), {{"ring", test::ring()}}, ordered);
  const ContestResult& result = race.results.front();
  const DriveRecord record = test::driven("flood").record;
  ASSERT_EQ(record.runs.size(), 3U);
  EXPECT_EQ(number(result, &F::search), record.runs[2].begin);
  EXPECT_EQ(number(result, &F::starts), 2);
  EXPECT_EQ(number(result, &F::best), *record.runs[2].centre - record.runs[2].begin);
  const DriveScore scored = score(record, rules_called("all-japan"));
  EXPECT_EQ(figure_of(race, result, "score"), Value(JsonText{score_json(scored).dump()}));
  EXPECT_DOUBLE_EQ(*result.score, static_cast<double>(*scored.value()) / 1e6);
  EXPECT_EQ(number(result, &F::proven), record.runs[2].known == record.runs[2].possible ? 1 : 0);
}

TEST(SecondsWorld, SharesAreOfTheReachableCells) {
  const Race race = hold_race(mice("flood,certify"), {{"ring", test::ring()}}, order());
  for (const ContestResult& result : race.results) {
    EXPECT_GE(number(result, &F::discovered), number(result, &F::visited));
    EXPECT_LE(number(result, &F::discovered), 1.0);
    EXPECT_GT(number(result, &F::visited), 0.0);
  }
}

TEST(SecondsWorld, CertifiedRunsAreTheBestThatThereAre) {
  const Race race = hold_race(mice("certify"), some_mazes(), order());
  const Standing standing = standings_of(race).front();
  EXPECT_GT(standing.runs, 3);
  // Where no route leads on from the start the search alone scores.
  int routes = 0;
  for (std::size_t maze = 0; maze < race.mazes.size(); ++maze) routes += fastest(race, maze) ? 1 : 0;
  EXPECT_GT(standing.runs, routes);
  EXPECT_EQ(number(race, standing, "optimal"), routes);
  EXPECT_EQ(number(race, standing, "proven"), routes);
  EXPECT_EQ(standing.finished, standing.runs);
  EXPECT_EQ(number(race, standing, "mean_excess"), 0.0);
}

/// Flood finds the way along the middle row; only certify looks whether the upper row is open, too, which makes a
/// diagonal the faster way.
Maze with_a_faster_way() {
  return test::drawn(R"(
    o---o---o---o---o
    |             G |
    o   o   o---o   o
    |               |
    o   o   o   o   o
    | S |       |   |
    o---o---o---o---o
  )");
}

/// The same where that does not help.
Maze without_a_faster_way() {
  return test::drawn(R"(
    o---o---o---o
    |   |     G |
    o   o---o   o
    |           |
    o   o   o---o
    |   |       |
    o   o---o---o
    | S |       |
    o---o---o---o
  )");
}

TEST(SecondsWorld, TellsWhoHasProvenThatNothingIsLeftToHopeFor) {
  const std::vector<NamedMaze> mazes = {{"faster", with_a_faster_way()}, {"no faster", without_a_faster_way()}};
  const Race race = hold_race(mice("flood,certify"), mazes, order());
  ASSERT_EQ(race.results.size(), 4U);
  for (const ContestResult& result : race.results) {
    SCOPED_TRACE(race.mice[result.mouse].name + " in " + race.mazes[result.maze].name);
    const bool certify = race.mice[result.mouse].name == "certify", faster = race.mazes[result.maze].name == "faster";
    ASSERT_TRUE(number(result, &F::best) && fastest(race, result.maze));
    EXPECT_EQ(number(result, &F::starts), 2);
    EXPECT_EQ(number(result, &F::proven), certify ? 1 : 0);
    // It may drive the best route without knowing that.
    EXPECT_EQ(number(result, &F::best) == fastest(race, result.maze), certify || !faster);
  }
}

TEST(SecondsWorld, ProvesNothingWithoutASpeedRun) {
  DriveRules once = rules_called("all-japan");
  once.most_runs = 1;
  const Race race = hold_race(mice("certify"), {{"faster", with_a_faster_way()}}, order(once));
  EXPECT_EQ(number(race.results.front(), &F::starts), 1);
  EXPECT_EQ(number(race.results.front(), &F::proven), 0);
}

TEST(SecondsWorld, HandsOverRecordsThatCanBePlayedAgain) {
  int told = 0;
  RaceHooks hooks;
  hooks.keep = [](const ContestResult&) { return Keep{true, false}; };
  hooks.finished = [&](const Race& race, const ContestResult& result, const ContestOutput& held) {
    ++told;
    const auto read = read_drive_record(held.record);
    ASSERT_TRUE(read.file);
    EXPECT_FALSE(held.run);
    EXPECT_EQ(replay(*read.file), "") << race.mice[result.mouse].name << " in " << race.mazes[result.maze].name;
  };
  const RaceOrder ordered = order(rules_called("thirtieth"));
  const std::vector<Contestant> all = residents_of(*ordered.world);
  hold_race(all, some_mazes(), ordered, hooks);
  EXPECT_EQ(told, static_cast<int>(all.size() * some_mazes().size()));
}

/// Two mice with made-up results in two mazes.
Race made_up() {
  Race race;
  race.order = order(rules_called("thirtieth"));
  race.mice.resize(2);
  race.mice[0].name = "quick";
  race.mice[1].name = "slow";
  race.mazes = {{"a", test::ring()}, {"b", test::ring()}, {"c", test::ring()}};
  race.facts = {{5.0, 4e6, {}}, {10.0, 8e6, {}}, {{}, {}, {}}};
  const auto add = [&](std::size_t mouse, std::size_t maze, std::int64_t value, std::int64_t best, double excess) {
    ContestResult& result = race.results.emplace_back();
    result.mouse = mouse;
    result.maze = maze;
    result.done = true;
    result.outcome = "out of time";
    const auto figures = std::make_shared<F>();
    figures->search = 30'000'000;
    figures->starts = 2;
    figures->discovered = 0.5;
    figures->visited = 0.25;
    result.figures = figures;
    if (value == 0) return;
    result.outcome = "finished";
    result.score = result.counted = static_cast<double>(value) / 1e6;
    result.ratio = *result.score / *race.facts[maze].bound;
    figures->score = JsonText{nlohmann::json{{"value", value}}.dump()};
    figures->score_us = value;
    figures->excess = excess;
    figures->best = figures->gate_to_gate = figures->rest_to_centre = best;
  };
  add(0, 0, 6'000'000, 5'000'000, 0.25);
  add(0, 1, 11'000'000, 8'000'000, 0.0);
  add(0, 2, 0, 0, 0.0);
  add(1, 0, 5'500'000, 4'000'000, 0.0);
  add(1, 1, 0, 0, 0.0);
  add(1, 2, 0, 0, 0.0);
  return race;
}

TEST(SecondsWorld, HasMeansOverTheMazesInWhichAMouseCanScore) {
  const Race race = made_up();
  const std::vector<Standing> standings = standings_of(race);
  ASSERT_EQ(standings.size(), 2U);
  const Standing& quick = standings[0];
  EXPECT_EQ(quick.mouse, 0U);  // who scores in more mazes comes first
  EXPECT_EQ(quick.runs, 2);
  EXPECT_EQ(quick.finished, 2);
  EXPECT_DOUBLE_EQ(*quick.mean_all, 8.5);
  EXPECT_DOUBLE_EQ(*quick.mean_ratio, (1.2 + 1.1) / 2);
  EXPECT_DOUBLE_EQ(*number(race, quick, "mean_search"), 30.0);
  EXPECT_DOUBLE_EQ(*number(race, quick, "mean_best"), 6.5);
  EXPECT_DOUBLE_EQ(*number(race, quick, "mean_excess"), 0.125);
  EXPECT_EQ(number(race, quick, "optimal"), 1);
  EXPECT_EQ(standings[1].finished, 1);
  EXPECT_EQ(standings[1].runs, 2);
  EXPECT_DOUBLE_EQ(*standings[1].mean_all, 5.5);
  EXPECT_DOUBLE_EQ(*number(race, standings[1], "mean_excess"), 0.0);
}

TEST(SecondsWorld, HasATable) {
  const std::string table = table_of(made_up(), false);
  EXPECT_THAT(table, HasSubstr(R"(
                score,          95 % score /  search    best excess runs per
mouse finished       s      interval    best  run, s  run, s      %  contest
)"));
  EXPECT_THAT(table, HasSubstr("\nquick      2/2   8.500    0.00-40.27   1.150    30.0   6.500  12.50      2.0\n"));
  EXPECT_THAT(table, HasSubstr("\nRules thirtieth: "));
  EXPECT_THAT(table, Says("Robot mm2021", "90 mm"));
  EXPECT_THAT(table, Says("Left out", "1 maze", "(c)"));
  EXPECT_THAT(table, HasSubstr("\n  slow  out of time 1\n"));
}

TEST(SecondsWorld, WordsTheRules) {
  DriveRules rules;
  rules.time_limit = 600'000'000;
  EXPECT_THAT(formula_of(rules), AllOf(Says("5 runs", "600 s", "gate to gate"), Not(HasSubstr("maze"))));
  rules.gate_to_gate = false;
  rules.most_runs = 1;
  rules.maze_time_divisor = 30;
  rules.untouched_bonus = 2'500'000;
  EXPECT_THAT(formula_of(rules),
              Says("1 run ", "600 s", "rest to centre", "1/30 of the time in the maze", "2.5 s if untouched"));
}

TEST(SecondsWorld, HasAGroupOfItsOwnInJson) {
  const auto json = nlohmann::json::parse(json_of(made_up(), {{"no-maze", {{0, 0, "why"}}}}));
  EXPECT_EQ(json["groups"].size(), 1U);
  EXPECT_EQ(json["skipped"][0]["path"], "no-maze");
  const auto& group = json["groups"][0];
  EXPECT_EQ(group["world"], "seconds");
  EXPECT_EQ(group["rules"]["maze_time_divisor"], 30);
  EXPECT_EQ(group["robot"]["name"], "mm2021");
  EXPECT_EQ(group["mazes"][1]["bound_us"], 10'000'000);
  EXPECT_EQ(group["mazes"][2]["fastest_us"], nullptr);
  EXPECT_EQ(group["mice"][0]["name"], "quick");
  EXPECT_EQ(group["mice"][0]["results"][0]["score"]["value"], 6'000'000);
  EXPECT_EQ(group["mice"][1]["results"][1]["outcome"], "out of time");
}

TEST(SecondsWorld, HasCsv) {
  const std::string csv = csv_of(made_up());
  EXPECT_THAT(csv, StartsWith("mouse,maze,seed,outcome,score_us,gate_to_gate_us,"));
  EXPECT_THAT(csv,
              HasSubstr("\nquick,a,0,finished,6000000,5000000,5000000,30000000,5000000,4000000,5000000,false,2,0\n"));
  EXPECT_THAT(csv, HasSubstr("\nslow,b,0,out of time,,,,30000000,,8000000,10000000,false,2,0\n"));
}

}  // namespace
}  // namespace labmouse
