#include "labmouse/lab/races/drive_race.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "labmouse/lab/standings/drive_report.hpp"
#include "labmouse/lab/standings/drive_standings.hpp"
#include "tests/lab/drive_record_fixture.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

DriveRaceOrder order(const std::string& rules = "all-japan") {
  DriveRaceOrder order;
  order.rules = find_rules(rules).rules;
  order.model = test::drive_model("mm2021");
  order.jobs = 1;
  return order;
}

std::vector<Contestant> mice(const std::string& specs) { return read_specs(specs).contestants; }

std::vector<NamedMaze> some_mazes() {
  std::vector<NamedMaze> mazes = {{"ring", test::ring()}};
  Dice dice(11);
  for (int i = 0; i < 6; ++i) {
    const Maze maze = test::any_maze(dice, 8);
    mazes.push_back(
        {"maze " + std::to_string(i), maze.with_start({0, 0}, Heading::north).with_goals(centre_of(maze.size()))});
  }
  mazes.push_back({"closed", Maze(MazeDraft({3, 3}, MazeDraft::Inside::closed))});
  return mazes;
}

TEST(DriveRace, HoldsEveryMouseInEveryMaze) {
  const DriveRace race = hold_drive_race(mice("flood,certify"), some_mazes(), order());
  EXPECT_FALSE(race.stopped);
  ASSERT_EQ(race.mice.size(), 2U);
  EXPECT_EQ(race.mice[0].name, "certify");
  EXPECT_EQ(race.mazes[0].name, "closed");
  ASSERT_EQ(race.results.size(), 2 * race.mazes.size());
  EXPECT_EQ(drive_contests_of(race.mice, race.mazes.size(), race.order), race.results.size());
  for (const DriveResult& result : race.results) {
    EXPECT_TRUE(result.done);
    if (race.mazes[result.maze].name == "closed") {
      EXPECT_FALSE(race.bounds[result.maze].fastest);
      EXPECT_FALSE(counts(race, result));
    }
  }
}

TEST(DriveRace, SumsUpAContest) {
  const DriveRace race = hold_drive_race(mice("flood"), {{"ring", test::ring()}}, order());
  const DriveResult& result = race.results.front();
  const DriveRecord record = test::driven("flood").record;
  ASSERT_EQ(record.runs.size(), 3U);
  EXPECT_EQ(result.search, record.runs[2].begin);
  EXPECT_EQ(result.starts, 2);
  EXPECT_EQ(result.best, *record.runs[2].centre - record.runs[2].begin);
  EXPECT_EQ(result.score, score(record, race.order.rules));
  EXPECT_EQ(result.proven, record.runs[2].known == record.runs[2].hoped);
}

TEST(DriveRace, GivesTheSameOnAnyNumberOfThreads) {
  DriveRaceOrder many = order();
  many.jobs = 4;
  const DriveRace one = hold_drive_race(mice("flood,ariadne"), some_mazes(), order());
  const DriveRace four = hold_drive_race(mice("flood,ariadne"), some_mazes(), many);
  EXPECT_EQ(csv_of(one), csv_of(four));
}

TEST(DriveRace, CertifiedRunsAreTheBestThatThereAre) {
  const DriveRace race = hold_drive_race(mice("certify"), some_mazes(), order());
  const DriveStanding standing = drive_standings_of(race).front();
  EXPECT_GT(standing.runs, 3);
  // Where no route leads on from the start the search alone scores.
  const auto routes =
      std::count_if(race.bounds.begin(), race.bounds.end(), [](const DriveBound& b) { return b.fastest; });
  EXPECT_GT(standing.runs, routes);
  EXPECT_EQ(standing.optimal, routes);
  EXPECT_EQ(standing.proven, routes);
  EXPECT_EQ(standing.scored, standing.runs);
  EXPECT_EQ(standing.mean_excess, 0.0);
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

TEST(DriveRace, TellsWhoHasProvenThatNothingIsLeftToHopeFor) {
  const std::vector<NamedMaze> mazes = {{"faster", with_a_faster_way()}, {"no faster", without_a_faster_way()}};
  const DriveRace race = hold_drive_race(mice("flood,certify"), mazes, order());
  ASSERT_EQ(race.results.size(), 4U);
  for (const DriveResult& result : race.results) {
    SCOPED_TRACE(race.mice[result.mouse].name + " in " + race.mazes[result.maze].name);
    const bool certify = race.mice[result.mouse].name == "certify", faster = race.mazes[result.maze].name == "faster";
    ASSERT_TRUE(result.best && race.bounds[result.maze].fastest);
    EXPECT_EQ(result.starts, 2);
    EXPECT_EQ(result.proven, certify);
    // It may drive the best route without knowing that.
    EXPECT_EQ(*result.best == *race.bounds[result.maze].fastest, certify || !faster);
  }
}

TEST(DriveRace, ProvesNothingWithoutAFastRun) {
  DriveRaceOrder once = order();
  once.rules.most_runs = 1;
  const DriveRace race = hold_drive_race(mice("certify"), {{"faster", with_a_faster_way()}}, once);
  EXPECT_EQ(race.results.front().starts, 1);
  EXPECT_FALSE(race.results.front().proven);
}

TEST(DriveRace, CanBeStopped) {
  const std::atomic<bool> stop = true;
  DriveRaceHooks hooks;
  hooks.stop = &stop;
  const DriveRace race = hold_drive_race(mice("flood"), some_mazes(), order(), hooks);
  EXPECT_TRUE(race.stopped);
  EXPECT_EQ(drive_standings_of(race).front().runs, 0);
  EXPECT_THAT(table_of(race, false), HasSubstr("Stopped early: 0 of 8 contests done.\n"));
}

TEST(DriveRace, HandsOverRecordsThatCanBePlayedAgain) {
  int told = 0;
  DriveRaceHooks hooks;
  hooks.finished = [&](const DriveRace& race, const DriveResult& result, const DriveRecord& record) {
    ++told;
    const auto read = read_drive_record(write_drive_record(drive_record_file_of(race, result, record)));
    ASSERT_TRUE(read.file);
    EXPECT_EQ(read.file->record, record);
    EXPECT_EQ(replay(*read.file), "") << race.mice[result.mouse].name << " in " << race.mazes[result.maze].name;
  };
  hold_drive_race(all_drivers(), some_mazes(), order("thirtieth"), hooks);
  EXPECT_EQ(told, static_cast<int>(all_drivers().size() * some_mazes().size()));
}

/// Two mice with made-up results in two mazes.
DriveRace made_up() {
  DriveRace race;
  race.order = order("thirtieth");
  race.mice.resize(2);
  race.mice[0].name = "quick";
  race.mice[1].name = "slow";
  race.mazes = {{"a", test::ring()}, {"b", test::ring()}, {"c", test::ring()}};
  race.bounds = {{4'000'000, 5'000'000}, {8'000'000, 10'000'000}, {}};
  const auto add = [&](std::size_t mouse, std::size_t maze, std::optional<MazeTime> value, MazeTime best) {
    DriveResult result;
    result.mouse = mouse;
    result.maze = maze;
    result.done = true;
    result.search = 30'000'000;
    result.starts = 2;
    if (value) {
      result.best = best;
      result.score.runs.push_back({2, best, best, *value - best, 0, *value});
      result.score.best = 0;
    } else {
      result.score.outcome = DriveOutcome::out_of_time;
    }
    race.results.push_back(result);
  };
  add(0, 0, 6'000'000, 5'000'000);
  add(0, 1, 11'000'000, 8'000'000);
  add(0, 2, std::nullopt, 0);
  add(1, 0, 5'500'000, 4'000'000);
  add(1, 1, std::nullopt, 0);
  add(1, 2, std::nullopt, 0);
  return race;
}

TEST(DriveStandings, AreMeansOverTheMazesWithARoute) {
  const std::vector<DriveStanding> standings = drive_standings_of(made_up());
  ASSERT_EQ(standings.size(), 2U);
  const DriveStanding& quick = standings[0];
  EXPECT_EQ(quick.mouse, 0U);
  EXPECT_EQ(quick.runs, 2);
  EXPECT_EQ(quick.scored, 2);
  EXPECT_DOUBLE_EQ(*quick.mean_score, 8.5);
  EXPECT_DOUBLE_EQ(*quick.mean_ratio, (1.2 + 1.1) / 2);
  EXPECT_DOUBLE_EQ(*quick.mean_search, 30.0);
  EXPECT_DOUBLE_EQ(*quick.mean_best, 6.5);
  EXPECT_DOUBLE_EQ(*quick.mean_excess, 0.125);
  EXPECT_EQ(quick.optimal, 1);
  EXPECT_EQ(standings[1].scored, 1);
  EXPECT_EQ(standings[1].runs, 2);
  EXPECT_DOUBLE_EQ(*standings[1].mean_excess, 0.0);
}

TEST(DriveReport, IsATable) {
  const std::string table = table_of(made_up(), false);
  EXPECT_THAT(table, HasSubstr(R"(
                 score          95 %  score  search    best  above  best        runs
mouse   scored       s      interval /bound       s   run s  best%  runs proven each
)"));
  EXPECT_THAT(table,
              HasSubstr("\nquick      2/2   8.500    6.00-11.00  1.150    30.0   6.500  12.50     1      0  2.0\n"));
  EXPECT_THAT(table, HasSubstr("\nRules thirtieth: "));
  EXPECT_THAT(table, HasSubstr("Robot mm2021, cells of 90 mm."));
  EXPECT_THAT(table,
              HasSubstr("1 maze in which no mouse could score: not counted.\nslow without a score: out of time 1.\n"));
}

TEST(DriveReport, WordsTheRules) {
  DriveRules rules;
  rules.time_limit = 600'000'000;
  EXPECT_EQ(formula_of(rules), "the best of at most 5 runs in 600 s, gate to gate");
  rules.gate_to_gate = false;
  rules.most_runs = 1;
  rules.maze_time_divisor = 30;
  rules.untouched_bonus = 2'500'000;
  EXPECT_EQ(formula_of(rules),
            "the best of at most 1 run in 600 s, rest to centre, plus 1/30 of the time in the maze before it, less 2.5 "
            "s untouched");
}

TEST(DriveReport, IsJsonWithAGroupOfItsOwn) {
  const auto json = nlohmann::json::parse(json_of(made_up(), {{"no-maze", {{0, 0, "why"}}}}));
  EXPECT_TRUE(json["mice"].empty());
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

TEST(DriveReport, IsCsv) {
  const std::string csv = csv_of(made_up());
  EXPECT_THAT(csv, StartsWith("mouse,maze,seed,outcome,score_us,gate_to_gate_us,"));
  EXPECT_THAT(csv,
              HasSubstr("\nquick,a,0,finished,6000000,5000000,5000000,30000000,5000000,4000000,5000000,false,2,0\n"));
  EXPECT_THAT(csv, HasSubstr("\nslow,b,0,out of time,,,,30000000,,8000000,10000000,false,2,0\n"));
}

}  // namespace
}  // namespace labmouse
