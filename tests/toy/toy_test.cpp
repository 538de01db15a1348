// Everything that runs contests works with a world that only its own folder and the list of worlds know.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/reports/report_records.hpp"
#include "labmouse/lab/reports/report_results.hpp"
#include "labmouse/lab/result_folders/race_folder.hpp"
#include "labmouse/lab/standings/baseline.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/store/store.hpp"
#include "labmouse/lab/store/stored_races.hpp"
#include "labmouse/lab/store/verification.hpp"
#include "labmouse/lab/studies/study.hpp"
#include "labmouse/lab/studies/sweep.hpp"
#include "labmouse/lab/worlds/entering.hpp"
#include "tests/lab/page/page_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using testing::HasSubstr;

constexpr int runs = 12;

RaceOrder order_with(const std::string& clumsiness) {
  RaceOrder order;
  order.world = find_world("toy")->make({{"clumsiness", clumsiness}}).world;
  order.runs = runs;
  return order;
}

std::vector<NamedMaze> some_mazes() {
  const std::vector<std::string> names = {"contest-01", "contest-02", "contest-03"};
  return load_mazes(names).mazes;
}

Race toy_race(const std::string& clumsiness = "70") {
  return hold_race(read_specs("flood,certify").contestants, some_mazes(), order_with(clumsiness));
}

bool has_score(const ContestResult& contest) { return contest.score.has_value(); }

TEST(ToyWorld, ThrowsDiceForMiceThatThrowNone) {
  const Race race = toy_race();
  EXPECT_EQ(race.results.size(), 2U * 3U * runs);
  EXPECT_TRUE(std::any_of(race.results.begin(), race.results.end(), has_score));
  EXPECT_FALSE(std::all_of(race.results.begin(), race.results.end(), has_score));
}

TEST(ToyWorld, LeavesContestsWithoutAScoreOutOfAllMeans) {
  const Race race = toy_race();
  for (const Standing& standing : standings_of(race)) {
    EXPECT_EQ(standing.runs, 3 * runs);
    EXPECT_LT(standing.finished, standing.runs);
    EXPECT_EQ(standing.mean_all, standing.mean_finished);
  }
  EXPECT_FALSE(standings_of(toy_race("100")).front().mean_all.has_value());
}

TEST(ToyWorld, HasATableWithItsOwnColumns) {
  const std::string table = table_of(toy_race(), false);
  EXPECT_THAT(table, HasSubstr("world toy"));
  EXPECT_THAT(table, HasSubstr("a contest"));
  EXPECT_THAT(table, HasSubstr("stumbled"));
}

TEST(ToyWorld, IsAGroupOfTheJsonOfARace) {
  const auto json = nlohmann::json::parse(json_of(toy_race(), {}));
  ASSERT_EQ(json["groups"].size(), 1U);
  const auto& group = json["groups"][0];
  EXPECT_EQ(group["world"], "toy");
  EXPECT_EQ(group["clumsiness"], 70);
  EXPECT_EQ(group["mice"].size(), 2U);
  EXPECT_EQ(group["mice"][0]["results"].size(), 3U * runs);
  EXPECT_TRUE(group["mice"][0]["results"][0].contains("stumbles"));
}

/// The page's tests show the race in tests/toy/results.json; this checks that the program still gives the same.
TEST(ToyWorld, HasResultsThatThePageShows) {
  RaceOrder order = order_with("40");
  order.runs = 2;
  const Race race = hold_race(read_specs("flood,certify").contestants, some_mazes(), order);
  const auto json = nlohmann::json::parse(json_of(race, {}));
  std::ifstream file(std::filesystem::path(LABMOUSE_SOURCE_DIR) / "tests/toy/results.json");
  const auto kept = nlohmann::json::parse(file, nullptr, false);
  ASSERT_TRUE(kept.is_object());
  ASSERT_EQ(kept["groups"], json["groups"]) << json.dump(1);
  EXPECT_EQ(kept["groups"][0]["columns"], nlohmann::json({"stumbles a contest"}));
}

/// The lines of a record, but for the version that wrote it.
nlohmann::json lines_of(const std::string& record) {
  nlohmann::json lines = nlohmann::json::array();
  std::istringstream text(record);
  for (std::string line; std::getline(text, line);) lines.push_back(nlohmann::json::parse(line));
  lines.front().erase("version");
  return lines;
}

/// They show a report of a single contest, too: tests/toy/report.json has what such a report carries, and the contest's
/// record in lines.
TEST(ToyWorld, HasAReportThatThePageShows) {
  const std::string folder = testing::TempDir() + "toy-report";
  std::filesystem::remove_all(folder);
  RaceOrder order = order_with("40");
  order.runs = 1;
  RaceHooks hooks;
  hooks.keep = RaceFolder::keep;
  std::string record;
  hooks.finished = [&](const Race& race, const ContestResult& contest, const ContestOutput& held) {
    record = held.record;
    EXPECT_EQ(RaceFolder(folder, race).save(contest, held), "");
  };
  const Race race = hold_race(read_specs("certify").contestants, {some_mazes().front()}, order, hooks);
  const auto json = nlohmann::json::parse(json_of(race, {}));
  const ReadResultsResult results = read_report_results(json.dump());
  ASSERT_TRUE(results.results);
  const ReportRecords records = read_report_records(*results.results, folder);
  std::filesystem::remove_all(folder);
  EXPECT_TRUE(records.notes.empty());
  const nlohmann::json report = {{"groups", json["groups"]},
                                 {"records", nlohmann::json::parse(records.json)["records"]},
                                 {"record", lines_of(record)}};
  std::ifstream file(std::filesystem::path(LABMOUSE_SOURCE_DIR) / "tests/toy/report.json");
  ASSERT_EQ(nlohmann::json::parse(file, nullptr, false), report) << report.dump(1);
}

/// A page that knows no world by name gets from `about` which settings a world has, and can run a race in it.
TEST(ToyWorld, IsOfferedAndHeldByThePage) {
  const auto worlds = test::answer("about", nlohmann::json::object())["worlds"];
  ASSERT_EQ(worlds.back()["name"], "toy");
  const nlohmann::json setting = {{"name", "clumsiness"},
                                  {"type", "whole"},
                                  {"default", "50"},
                                  {"meaning", "How often a mouse stumbles"},
                                  {"low", 0},
                                  {"high", 100}};
  EXPECT_EQ(worlds.back()["settings"], nlohmann::json::array({setting}));
  EXPECT_EQ(worlds.back()["plays"], true);
  const auto& mice = worlds.back()["mice"];
  EXPECT_NE(std::find(mice.begin(), mice.end(), "flood"), mice.end());
  const auto maze = maze_data("contest-01", some_mazes().front().maze);
  const auto race = test::said("race", {{"mice", {"flood"}},
                                        {"mazes", {nlohmann::json::parse(maze.dump())}},
                                        {"seed", 1},
                                        {"runs", 2},
                                        {"world", "toy"},
                                        {"clumsiness", 100}});
  const auto& groups = race["answer"]["results"]["groups"];
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0]["clumsiness"], 100);
  EXPECT_EQ(groups[0]["mice"][0]["results"][0]["outcome"], "stumbled");
}

TEST(ToyWorld, HasALineOfCsvForEachContest) {
  const std::string csv = csv_of(toy_race());
  EXPECT_TRUE(csv.starts_with("mouse,maze,score,stumbles\n"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 3 * runs);
}

TEST(ToyWorld, IsItsOwnBaseline) {
  const Race race = toy_race();
  const ReadBaselineResult read = read_baseline(json_of(race, {}), race.world());
  ASSERT_TRUE(read.baseline) << read.error;
  const std::string same = compare_with_baseline(race, *read.baseline);
  EXPECT_THAT(same, HasSubstr("+0.000"));
  EXPECT_THAT(same, testing::Not(HasSubstr("Warning")));
  EXPECT_THAT(compare_with_baseline(toy_race("30"), *read.baseline), Says("Warning", "clumsiness", "70", "30"));
  EXPECT_FALSE(read_baseline(json_of(race, {}), *find_world("seconds")->make({}).world).baseline);
}

TEST(ToyWorld, SaysWhichMazesCostMost) { EXPECT_THAT(worst_of(toy_race(), 1), HasSubstr("= bound")); }

TEST(ToyWorld, LeavesRecordsInAFolderAndResultsForAReport) {
  const std::string folder = testing::TempDir() + "toy-race";
  std::filesystem::remove_all(folder);
  const Race race = toy_race();
  const RaceFolder gallery(folder, race);
  EXPECT_EQ(gallery.save(race.results.front(), {{}, "{\"run\":1}\n", ""}), "");
  EXPECT_TRUE(std::filesystem::exists(folder + "/certify/contest-01-1.jsonl"));
  const ReadResultsResult read = read_report_results(json_of(race, {}));
  ASSERT_TRUE(read.results);
  EXPECT_EQ(read.results->worlds.back().entry->name, "toy");
  EXPECT_EQ(read.results->worlds.back().mice.front().seeds.begin()->second.size(), static_cast<std::size_t>(runs));
  std::filesystem::remove_all(folder);
}

TEST(ToyWorld, IsKeptInAStoreAndComesBack) {
  const std::string path = testing::TempDir() + "toy-store.db";
  std::filesystem::remove(path);
  std::string json[3];
  for (int i = 0; i < 2; ++i) {
    const auto store = std::make_shared<Store>(path);
    RaceOrder order = order_with("70");
    order.store = store;
    json[i] = json_of(hold_race(read_specs("flood,certify").contestants, some_mazes(), order), {});
    EXPECT_EQ(store->finish(), "");
    EXPECT_EQ(store->recalled(), i == 0 ? 0U : 2U * 3U * runs);
  }
  const auto store = std::make_shared<Store>(path);
  RaceOrder other = order_with("60");
  other.store = store;
  hold_race(read_specs("flood").contestants, some_mazes(), other);
  EXPECT_EQ(store->finish(), "");
  EXPECT_EQ(store->recalled(), 0U);
  const StoredRaces stored = stored_races(path, {});
  ASSERT_EQ(stored.races.size(), 2U) << stored.error;
  json[2] = json_of(stored.races.front(), {});
  EXPECT_EQ(json[0], json_of(toy_race(), {}));
  EXPECT_EQ(json[1], json[0]);
  EXPECT_EQ(json[2], json[0]);
  EXPECT_EQ(verify_store(path, {}, {1.0}).equal, 3 * 3 * runs);
  std::filesystem::remove(path);
}

TEST(ToyWorld, IsStudied) {
  StudyOrder order;
  order.race = order_with("20");
  order.folds = 3;
  const Study study = hold_study(read_specs("flood,certify").contestants, some_mazes(), order);
  ASSERT_EQ(study.error, "");
  EXPECT_EQ(study.folds_done, 3);
  EXPECT_THAT(table_of(study, false), HasSubstr("a contest"));
  EXPECT_EQ(nlohmann::json::parse(json_of(study, {}))["groups"][0]["mazes"][0]["fold"].is_number(), true);
}

TEST(ToyWorld, IsSwept) {
  const SweptValues variation = read_swept_values("stride=1:3:1");
  const Sweep sweep = hold_sweep("flood", variation, some_mazes(), order_with("20"));
  ASSERT_EQ(sweep.error, "");
  EXPECT_EQ(sweep.points.size(), 3U);
  EXPECT_TRUE(sweep.points.front().mean && sweep.points.back().mean &&
              *sweep.points.front().mean > *sweep.points.back().mean);
}

TEST(ToyWorld, IsEnteredByNameAndRefusesWhoCannotWalk) {
  const EntriesResult entered = enter(read_specs("flood").contestants, "toy", {});
  ASSERT_EQ(entered.error, "");
  EXPECT_EQ(entered.entries.front().world->traits().name, "toy");
  EXPECT_THAT(enter(read_specs("mms:true").contestants, "toy", {}).error, HasSubstr("cannot walk"));
  EXPECT_EQ(enter(read_specs("flood").contestants, "", {}).entries.front().world->traits().name,
            all_worlds().front()->name);
}

TEST(ToyWorld, StopsWhereItIsToldTo) {
  const std::atomic<bool> stop = true;
  RaceHooks hooks;
  hooks.stop = &stop;
  EXPECT_TRUE(hold_race(read_specs("flood").contestants, some_mazes(), order_with("50"), hooks).stopped);
}

}  // namespace
}  // namespace labmouse
