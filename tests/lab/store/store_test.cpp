// A store of contests: what is there is not run again, and comes back as it was.
#include "labmouse/lab/store/store.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/store/contest_key.hpp"
#include "labmouse/lab/store/differences.hpp"
#include "labmouse/lab/store/schema.hpp"
#include "labmouse/lab/store/store_changes.hpp"
#include "labmouse/lab/store/stored_races.hpp"
#include "labmouse/lab/store/verification.hpp"
#include "labmouse/lab/studies/study.hpp"
#include "labmouse/lab/studies/sweep.hpp"
#include "labmouse/lab/studies/tune.hpp"
#include "labmouse/lab/system/file_lock.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;
using test::Says;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Access = Database::Access;

/// A folder for stores that goes away with the test, and races that count the mice that were made for their contests.
class AStore : public testing::Test {
 protected:
  AStore() { fs::create_directories(folder_); }
  ~AStore() override { fs::remove_all(folder_); }

  std::string path(const std::string& name = "results.db") const { return (folder_ / name).string(); }

  std::vector<Contestant> counted_mice(std::string_view specs) {
    std::vector<Contestant> mice = test::mice(specs);
    for (Contestant& mouse : mice) {
      auto& make = std::get<Decider>(mouse.kind).make;
      make = [this, original = make](const Maze& maze, const Briefing& briefing) {
        ++held_;
        return original(maze, briefing);
      };
    }
    return mice;
  }
  /// A race with a store of that name; held_ says how many contests it held.
  Race race(std::string_view specs,
            std::vector<NamedMaze> mazes = {test::loop(), test::corridor(), test::without_route()},
            RaceOrder order = test::in_steps(), const std::string& name = "results.db") {
    held_ = 0;
    const auto store = std::make_shared<Store>(path(name));
    order.store = store;
    Race race = hold_race(counted_mice(specs), std::move(mazes), order);
    EXPECT_EQ(store->finish(), "");
    recalled_ = store->recalled();
    added_ = store->added();
    return race;
  }

  Database open(const std::string& name = "results.db") const { return open_store(path(name), Access::write); }
  std::int64_t number(const std::string& sql, const std::string& name = "results.db") const {
    Database database = open(name);
    const std::int64_t found = database.number(sql);
    EXPECT_EQ(database.error(), "");
    return found;
  }
  void change(const std::string& sql, const std::string& name = "results.db") const {
    Database database = open(name);
    database.run(sql);
    EXPECT_EQ(database.error(), "");
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("labmouse-store-" + std::to_string(getpid()) + "-" +
                                                     testing::UnitTest::GetInstance()->current_test_info()->name());
  std::atomic<std::size_t> held_{0};
  std::size_t recalled_ = 0, added_ = 0;
};

constexpr const char* three_mice = "flood,certify,random";
constexpr std::size_t contests_of_three = 3 + 3 + 60;

/// A race without the figures that the clock makes.
std::string without_timings(Race race) {
  const StoredFigures& stored = race.world().fields().figures;
  for (ContestResult& contest : race.results) {
    std::vector<Value> figures = stored.values_of(*contest.figures);
    for (std::size_t i = 0; i < figures.size(); ++i)
      if (stored.all[i].by_clock) figures[i] = Value(0.0);
    contest.figures = stored.figures_of(figures);
  }
  return json_of(race, {});
}

TEST_F(AStore, HoldsNoContestTwice) {
  const Race first = race(three_mice);
  EXPECT_EQ(held_, contests_of_three);
  EXPECT_EQ(added_, contests_of_three);
  const Race second = race(three_mice);
  EXPECT_EQ(held_, 0U);
  EXPECT_EQ(recalled_, contests_of_three);
  EXPECT_EQ(added_, 0U);
  // With the timings of the first.
  EXPECT_EQ(json_of(second, {}), json_of(first, {}));
  EXPECT_EQ(table_of(second, false), table_of(first, false));
  EXPECT_EQ(without_timings(second), without_timings(test::race_of(three_mice)));
}

TEST_F(AStore, HoldsWhatIsNew) {
  race("flood", {test::loop()});
  race("flood,certify", {test::loop()});
  EXPECT_EQ(held_, 1U);
  race("flood,certify", {test::loop(), test::hook()});
  EXPECT_EQ(held_, 2U);
  RaceOrder order = test::in_steps();
  order.runs = 30;
  race("random", {test::hook()});
  race("random", {test::hook()}, order);
  EXPECT_EQ(held_, 10U);
  EXPECT_EQ(recalled_, 20U);
}

TEST_F(AStore, KnowsWhatDeterminesAContest) {
  race("flood", {test::loop()});
  const auto holds_again = [&](std::string_view specs, NamedMaze maze, const RaceOrder& order = test::in_steps()) {
    race(specs, {std::move(maze)}, order);
    return held_ > 0;
  };
  EXPECT_FALSE(holds_again("flood", test::loop()));
  EXPECT_FALSE(holds_again("flood:stride=3", test::loop()));
  EXPECT_FALSE(holds_again("quick=flood", test::loop()));
  EXPECT_TRUE(holds_again("flood:stride=2", test::loop()));
  NamedMaze turned = test::loop();
  turned.maze = turned.maze.with_start(turned.maze.start(), Heading::east);
  EXPECT_TRUE(holds_again("flood", turned));
  NamedMaze near = test::loop();
  CellSet goals;
  goals.insert({0, 4});
  near.maze = near.maze.with_goals(goals);
  EXPECT_TRUE(holds_again("flood", near));
  Rules rules;
  rules.budget = 999;
  EXPECT_TRUE(holds_again("flood", test::loop(), test::in_steps(rules)));
  RaceOrder seeded = test::in_steps();
  seeded.seed = 2;
  EXPECT_TRUE(holds_again("flood", test::loop(), seeded));
}

TEST_F(AStore, KnowsTheBuildOfItsMice) {
  race("flood", {test::loop()});
  change("UPDATE mice SET text = replace(text, 'signature ', 'signature 0')");
  race("flood", {test::loop()});
  EXPECT_EQ(held_, 1U);
  EXPECT_EQ(number("SELECT count(*) FROM contests"), 2);
}

TEST_F(AStore, TellsALearnedMouseFromAnother) {
  StudyOrder order;
  order.race = test::in_steps();
  order.folds = 2;
  const auto study = [&] {
    const auto store = std::make_shared<Store>(path());
    order.race.store = store;
    const Study found = hold_study(test::mice("ariadne,flood"), {test::loop(), test::hook()}, order);
    EXPECT_EQ(store->finish(), "");
    recalled_ = store->recalled();
    return table_of(found, false);
  };
  const std::string first = study();
  EXPECT_EQ(recalled_, 0U);
  EXPECT_EQ(study(), first);
  EXPECT_EQ(recalled_, 4U);
  EXPECT_EQ(number("SELECT count(*) FROM mice WHERE name = 'ariadne'"), 2);
  // What a study taught is no mouse of a race.
  race("ariadne", {test::loop()});
  EXPECT_EQ(held_, 1U);
  EXPECT_EQ(stored_races(path(), {{}, {"ariadne"}, {"loop"}, {}, {}}).races.at(0).results.size(), 1U);
}

TEST_F(AStore, ServesSweepsAndSearches) {
  const std::vector<NamedMaze> mazes = {test::loop(), test::hook()};
  TuneOrder tuning;
  tuning.evaluations = 6;
  std::string tables[2];
  for (std::string& table : tables) {
    const auto store = std::make_shared<Store>(path());
    RaceOrder order = test::in_steps();
    order.store = tuning.race.store = store;
    tuning.race.world = order.world;
    table = table_of(hold_sweep("flood", read_variation("stride=1:3:1"), mazes, order), false);
    table += csv_of(hold_tune("cautious", read_ranges("cautious", "explore_frac").ranges, mazes, tuning));
    EXPECT_EQ(store->finish(), "");
    recalled_ = store->recalled();
    added_ = store->added();
  }
  EXPECT_EQ(tables[0], tables[1]);
  EXPECT_GT(recalled_, 6U);
  EXPECT_EQ(added_, 0U);
}

TEST_F(AStore, HasNoRecords) {
  race("flood", {test::loop()});
  const auto store = std::make_shared<Store>(path());
  RaceOrder order = test::in_steps();
  order.store = store;
  RaceHooks hooks;
  std::size_t records = 0;
  hooks.keep = [](const ContestResult&) { return Keep{true, false}; };
  hooks.finished = [&](const Race&, const ContestResult&, const ContestOutput& held) {
    records += held.record.empty() ? 0 : 1;
  };
  hold_race(test::mice("flood"), {test::loop(), test::hook()}, order, hooks);
  EXPECT_EQ(store->finish(), "");
  EXPECT_EQ(records, 2U);
  EXPECT_EQ(store->recalled(), 0U);
  EXPECT_EQ(store->added(), 1U);
}

TEST_F(AStore, TellsOfContestsThatItHad) {
  race("flood,certify");
  RaceOrder order = test::in_steps();
  order.store = std::make_shared<Store>(path());
  RaceHooks hooks;
  std::size_t told = 0;
  hooks.finished = [&](const Race&, const ContestResult& contest, const ContestOutput&) {
    told += contest.done ? 1 : 0;
  };
  hold_race(test::mice("flood,certify"), {test::loop(), test::corridor(), test::without_route()}, order, hooks);
  EXPECT_EQ(told, 6U);
}

TEST_F(AStore, KeepsWhatWasDoneBeforeAStop) {
  std::atomic<bool> stop = false;
  const auto store = std::make_shared<Store>(path());
  RaceOrder order = test::in_steps();
  order.store = store;
  order.jobs = 1;
  RaceHooks hooks;
  hooks.stop = &stop;
  hooks.finished = [&, done = 0](const Race&, const ContestResult&, const ContestOutput&) mutable {
    stop = ++done == 7;
  };
  EXPECT_TRUE(hold_race(test::mice("random"), {test::loop()}, order, hooks).stopped);
  EXPECT_EQ(store->finish(), "");
  EXPECT_EQ(store->added(), 7U);
  race("random", {test::loop()});
  EXPECT_EQ(held_, 13U);
}

TEST_F(AStore, IsWrittenWhereItIsNotFinished) {
  RaceOrder order = test::in_steps();
  order.store = std::make_shared<Store>(path());
  hold_race(test::mice("flood"), {test::loop()}, order);
  order.store.reset();
  EXPECT_EQ(number("SELECT count(*) FROM contests"), 1);
}

TEST_F(AStore, PassesByMiceOfWhichNothingIsKnown) {
  Contestant stranger = test::mice("flood").front();
  stranger.name = "stranger";
  const auto store = std::make_shared<Store>(path());
  RaceOrder order = test::in_steps();
  order.store = store;
  EXPECT_FALSE(hold_race({stranger}, {test::loop()}, order).stopped);
  EXPECT_EQ(store->finish(), "");
  EXPECT_EQ(store->added(), 0U);
  EXPECT_EQ(store->passed_by(), 1U);
}

TEST_F(AStore, TakesTwoRacesAtOnce) {
  const auto both = [&](std::size_t number) {
    const auto store = std::make_shared<Store>(path());
    RaceOrder order = test::in_steps();
    order.runs = 300;
    order.store = store;
    hold_race(test::mice(number == 0 ? "random,flood" : "random,certify"), {test::loop()}, order);
    EXPECT_EQ(store->finish(), "");
  };
  std::thread other([&] { both(1); });
  both(0);
  other.join();
  EXPECT_EQ(number("SELECT count(*) FROM contests"), 302);
  EXPECT_EQ(number("SELECT count(*) FROM timings"), 302);
  EXPECT_EQ(number("SELECT count(*) FROM mice"), 3);
  EXPECT_THAT(verify_store(path(), {}, {}).error, IsEmpty());
}

// Shards and merging.

RaceOrder shard(std::size_t number, std::size_t of) {
  RaceOrder order = test::in_steps();
  order.shard = {number, of};
  return order;
}

TEST_F(AStore, IsPutTogetherFromShards) {
  const Race whole = race(three_mice);
  const std::vector<NamedMaze> mazes = {test::loop(), test::corridor(), test::without_route()};
  std::vector<std::string> parts;
  std::size_t held = 0;
  for (std::size_t number = 1; number <= 7; ++number) {
    parts.push_back(path("part-" + std::to_string(number)));
    const Race part = race(three_mice, mazes, shard(number, 7), "part-" + std::to_string(number));
    EXPECT_EQ(part.results.size(), contests_of(part.mice, part.mazes.size(), shard(number, 7)));
    EXPECT_FALSE(part.stopped);
    held += held_;
  }
  EXPECT_EQ(held, contests_of_three);
  const Merge merge = merge_stores(parts, path("all.db"));
  EXPECT_TRUE(merge.good()) << merge.error;
  EXPECT_EQ(merge.added, static_cast<std::int64_t>(contests_of_three));
  EXPECT_EQ(merge.equal, 0);
  const StoredRaces stored = stored_races(path("all.db"), {});
  ASSERT_THAT(stored.races, SizeIs(1)) << stored.error;
  EXPECT_THAT(stored.remarks, IsEmpty());
  EXPECT_EQ(without_timings(stored.races[0]), without_timings(whole));
  race(three_mice, mazes, test::in_steps(), "all.db");
  EXPECT_EQ(held_, 0U);
}

TEST_F(AStore, HasAShardForEachContest) {
  for (std::size_t of : {1U, 2U, 5U, 64U, 100U}) {
    std::size_t all = 0;
    for (std::size_t number = 1; number <= of; ++number)
      all += contests_of(test::mice(three_mice), 3, shard(number, of));
    EXPECT_EQ(all, contests_of_three) << of;
  }
}

TEST_F(AStore, IsMergedIntoAnother) {
  race("flood", {test::loop(), test::hook()}, test::in_steps(), "one.db");
  race("flood,certify", {test::loop()}, test::in_steps(), "two.db");
  change("UPDATE timings SET figures = '[1.0]'", "two.db");
  const Merge merge = merge_stores({path("two.db")}, path("one.db"));
  EXPECT_TRUE(merge.good()) << merge.error;
  EXPECT_EQ(merge.added, 1);
  EXPECT_EQ(merge.equal, 1);
  EXPECT_EQ(number("SELECT count(*) FROM contests", "one.db"), 3);
  EXPECT_EQ(number("SELECT count(*) FROM timings", "one.db"), 3);
  // The first that was there stays.
  EXPECT_EQ(number("SELECT count(*) FROM timings WHERE figures = '[1.0]'", "one.db"), 1);
  change("DELETE FROM timings", "one.db");
  merge_stores({path("two.db")}, path("one.db"));
  EXPECT_EQ(number("SELECT count(*) FROM timings", "one.db"), 2);
  EXPECT_EQ(number("SELECT count(*) FROM bounds", "one.db"), 2);
  for (const auto& entry : fs::directory_iterator(folder_))
    EXPECT_THAT(entry.path().filename().string(), testing::Not(HasSubstr("merging")));
  EXPECT_EQ(verify_store(path("one.db"), {}, {1.0}).held, 3);
}

TEST_F(AStore, IsNotMergedWithOneThatContradicts) {
  for (const char* difference : {"score = 3", "score = NULL", "outcome = 'out of steps'", "counted = 3", "ratio = 3",
                                 "figures = '[1]'", "never_started = 'no'"}) {
    race("flood,certify", {test::loop()}, test::in_steps(), "one.db");
    race("flood,manhattan", {test::loop()}, test::in_steps(), "two.db");
    change(
        std::string("UPDATE contests SET ") + difference + " WHERE mouse IN (SELECT id FROM mice WHERE name = 'flood')",
        "two.db");
    for (const char* target : {"one.db", "new.db"}) {
      const Merge merge = merge_stores({path("one.db"), path("two.db")}, path(target));
      if (std::string(target) == "one.db") {
        EXPECT_THAT(merge.error, HasSubstr("one.db")) << "into itself";
        continue;
      }
      EXPECT_THAT(merge.conflicts, SizeIs(1)) << difference;
      EXPECT_THAT(merge.conflicts[0], Says("two.db", "flood", "loop"));
      EXPECT_FALSE(fs::exists(path(target)));
    }
    EXPECT_THAT(merge_stores({path("two.db")}, path("one.db")).conflicts, SizeIs(1));
    EXPECT_EQ(number("SELECT count(*) FROM contests", "one.db"), 2) << difference;
    EXPECT_EQ(number("SELECT count(*) FROM mice", "one.db"), 2) << difference;
    fs::remove(path("one.db"));
    fs::remove(path("two.db"));
  }
}

TEST_F(AStore, FindsNoConflictInAFormerNameOfAnOutcome) {
  race("flood", {test::loop()}, test::in_steps(), "one.db");
  race("flood", {test::loop()}, test::in_steps(), "two.db");
  change("UPDATE contests SET outcome = 'solved'", "two.db");
  const Merge merge = merge_stores({path("one.db"), path("two.db")}, path("new.db"));
  EXPECT_THAT(merge.conflicts, IsEmpty());
  EXPECT_EQ(merge.equal, 1);
}

TEST_F(AStore, NamesTheFirstConflictsOfTheFirstPartThatHasSome) {
  race("random", {test::loop()}, test::in_steps(), "one.db");
  for (const char* name : {"two.db", "three.db"}) {
    fs::copy_file(path("one.db"), path(name));
    change("UPDATE contests SET outcome = 'another'", name);
  }
  const Merge merge = merge_stores({path("one.db"), path("two.db"), path("three.db")}, path("all.db"));
  EXPECT_EQ(merge.error, "");
  ASSERT_THAT(merge.conflicts, SizeIs(11));  // of 20
  for (const std::string& line : merge.conflicts) EXPECT_THAT(line, HasSubstr("two.db"));
  EXPECT_THAT(merge.conflicts.back(), HasSubstr("10 more"));
}

TEST_F(AStore, MergesNothingOfOneWhoseContestsBelongToNothing) {
  for (const char* table : {"worlds", "mice", "mazes", "builds"}) {
    race("flood", {test::loop()}, test::in_steps(), "one.db");
    race("certify", {test::loop()}, test::in_steps(), "two.db");
    change(std::string("DELETE FROM ") + table, "two.db");
    EXPECT_THAT(merge_stores({path("two.db")}, path("one.db")).error, Says("two.db: error: ", "damaged")) << table;
    EXPECT_EQ(number("SELECT count(*) FROM contests", "one.db"), 1) << table;
    fs::remove(path("one.db"));
    fs::remove(path("two.db"));
  }
}

TEST_F(AStore, MergesNothingWhereAPartIsNone) {
  race("flood", {test::loop()});
  std::ofstream(path("text")) << "no store, and long enough to be looked at: " << std::string(4096, 'x');
  EXPECT_THAT(merge_stores({path(), path("text")}, path("new.db")).error, HasSubstr("text"));
  EXPECT_THAT(merge_stores({path(), path("missing")}, path("new.db")).error, HasSubstr("missing"));
  EXPECT_THAT(merge_stores({path()}, path("text")).error, HasSubstr("text"));
  EXPECT_FALSE(fs::exists(path("new.db")));
}

TEST_F(AStore, IsRidOfWhatAKilledMergeLeft) {
  race("flood", {test::loop()}, test::in_steps(), "part.db");
  // What it had put together does not belong to another merge.
  race("certify,manhattan", {test::loop()}, test::in_steps(), "all.db.merging-1");
  for (const char* left : {"all.db.merging-1-wal", "all.db.merging-1-lock", "all.db.merging-7", "all.db.merging-7-lock",
                           "all.db.merging-9-shm", "all.db.merging-8", "all.db.merging-notes", "other.db.merging-7"})
    std::ofstream(path(left)) << "left";
  int error = 0;
  const Descriptor at_work = locked_file(path("all.db.merging-8-lock"), error);
  ASSERT_EQ(error, 0);
  const Merge merge = merge_stores({path("part.db")}, path("all.db"));
  EXPECT_TRUE(merge.good()) << merge.error;
  EXPECT_EQ(number("SELECT count(*) FROM contests", "all.db"), 1);
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename().string());
  EXPECT_THAT(names, testing::UnorderedElementsAre("part.db", "all.db", "all.db.merging-8", "all.db.merging-8-lock",
                                                   "all.db.merging-notes", "other.db.merging-7"));
}

TEST_F(AStore, TakesSeveralMergesAtOnce) {
  constexpr std::size_t all = 6;
  for (int round = 0; round < 5; ++round) {
    const std::string target = "all-" + std::to_string(round) + ".db";
    for (std::size_t number = 1; number <= all; ++number)
      if (round == 0)
        race(three_mice, {test::loop(), test::corridor(), test::without_route()}, shard(number, all),
             "part-" + std::to_string(number));
    std::vector<std::thread> threads;
    for (std::size_t number = 1; number <= all; ++number)
      threads.emplace_back([this, target, number] {
        const Merge merge = merge_stores({path("part-" + std::to_string(number))}, path(target));
        EXPECT_TRUE(merge.good()) << merge.error;
      });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(number("SELECT count(*) FROM contests", target), static_cast<std::int64_t>(contests_of_three));
  }
  for (const auto& entry : fs::directory_iterator(folder_))
    EXPECT_THAT(entry.path().filename().string(), testing::Not(HasSubstr("merging")));
}

TEST_F(AStore, Forgets) {
  race(three_mice);
  EXPECT_EQ(forget(path(), {{}, {"random"}, {"loop"}, {}, {}}).contests, 20);
  EXPECT_EQ(number("SELECT count(*) FROM contests"), 46);
  EXPECT_EQ(number("SELECT count(*) FROM timings"), 46);
  EXPECT_EQ(forget(path(), {{}, {"flood"}, {}, {}, {}}).contests, 3);
  EXPECT_EQ(number("SELECT count(*) FROM mice"), 2);
  EXPECT_EQ(forget(path(), {{"seconds"}, {}, {}, {}, {}}).contests, 0);
  EXPECT_EQ(forget(path(), {{}, {}, {}, {}, 2}).contests, 0);
  EXPECT_EQ(forget(path(), {{}, {}, {"it's; DROP TABLE mice"}, {}, {}}).contests, 0);
  race(three_mice);
  EXPECT_EQ(held_, 23U);
  EXPECT_EQ(forget(path(), {{"strides"}, {}, {}, {}, 1}).contests, static_cast<std::int64_t>(contests_of_three));
  for (const char* table : {"contests", "timings", "worlds", "mice", "mazes", "bounds", "builds"})
    EXPECT_EQ(number(std::string("SELECT count(*) FROM ") + table), 0) << table;
}

TEST_F(AStore, OfAnEarlierVersionHasWorldsUnderTheirFormerNames) {
  race("flood");
  open().run("UPDATE worlds SET name = 'strides'");
  race("flood,certify");
  EXPECT_EQ(held_, 3U);
  EXPECT_EQ(number("SELECT count(*) FROM worlds"), 1);
  EXPECT_EQ(number("SELECT count(*) FROM worlds WHERE name = 'steps'"), 1);
}

// What a store says.

TEST_F(AStore, HasTheRaceInItsRows) {
  const Race held = race(three_mice);
  const StoredRaces stored = stored_races(path(), {});
  ASSERT_THAT(stored.races, SizeIs(1)) << stored.error;
  EXPECT_EQ(json_of(stored.races[0], {}), json_of(held, {}));
  EXPECT_EQ(table_of(stored.races[0], false), table_of(held, false));
}

TEST_F(AStore, TellsRacesApartByTheirSeeds) {
  RaceOrder other = test::in_steps();
  other.seed = 18'000'000'000'000'000'000U;
  race("random", {test::loop()});
  const Race second = race("random", {test::loop()}, other);
  EXPECT_THAT(stored_races(path(), {}).error, Says("1", "18000000000000000000", "--seed"));
  const StoredRaces stored = stored_races(path(), {{}, {}, {}, {}, other.seed});
  ASSERT_THAT(stored.races, SizeIs(1)) << stored.error;
  EXPECT_EQ(json_of(stored.races[0], {}), json_of(second, {}));
  EXPECT_THAT(stored_races(path(), {{}, {}, {}, {}, 3}).error, HasSubstr("results.db"));
}

TEST_F(AStore, SaysWhereARaceHasHoles) {
  race("flood", {test::loop()});
  race("certify", {test::hook()});
  EXPECT_THAT(stored_races(path(), {}).remarks, testing::ElementsAre(Says("2", "4")));
}

TEST_F(AStore, HasTheStandingsInAView) {
  const Race held = race(three_mice);
  Database database = open();
  for (const Standing& standing : standings_of(held)) {
    Statement find = database.prepare(
        "SELECT mazes, contests, solved, mean, mean_solved, mean_ratio FROM standings WHERE mouse = ?1");
    find.bind(1, held.mice[standing.mouse].name);
    ASSERT_TRUE(find.next());
    EXPECT_EQ(find.whole(0), standing.mazes);
    EXPECT_EQ(find.whole(1), standing.runs);
    EXPECT_EQ(find.whole(2), standing.finished);
    EXPECT_NEAR(*find.real(3), *standing.mean_all, 1e-9);
    EXPECT_NEAR(*find.real(4), *standing.mean_finished, 1e-9);
    EXPECT_NEAR(*find.real(5), *standing.mean_ratio, 1e-9);
  }
}

TEST_F(AStore, HasPairsInAView) {
  const Race held = race("flood,random", {test::loop(), test::corridor(), test::hook(), test::without_route()});
  const auto flood = scores_by_maze(held, 0), random = scores_by_maze(held, 1);
  double sum = 0.0;
  int mazes = 0, better = 0, equal = 0;
  for (std::size_t maze = 0; maze < flood.size(); ++maze) {
    if (!flood[maze] || !random[maze]) continue;
    ++mazes;
    sum += *flood[maze] - *random[maze];
    better += *flood[maze] < *random[maze] ? 1 : 0;
    equal += *flood[maze] == *random[maze] ? 1 : 0;
  }
  Database database = open();
  Statement find = database.prepare(
      "SELECT mazes, difference, better, equal, worse FROM pairs WHERE mouse = 'flood' AND against = 'random'");
  ASSERT_TRUE(find.next());
  EXPECT_EQ(find.whole(0), mazes);
  EXPECT_NEAR(*find.real(1), sum / mazes, 1e-9);
  EXPECT_EQ(find.whole(2), better);
  EXPECT_EQ(find.whole(3), equal);
  EXPECT_EQ(find.whole(4), mazes - better - equal);
  EXPECT_EQ(number("SELECT count(*) FROM pairs"), 2);
}

TEST(ConditionsOfAStore, AreToldApartByWhatDiffers) {
  const auto told = [](const std::vector<std::string>& conditions) { return differences_of(conditions); };
  EXPECT_THAT(told({R"({"budget":500})", R"({"budget":1000})"}), ElementsAre("budget 500", "budget 1000"));
  EXPECT_THAT(told({R"({"budget":500})"}), ElementsAre(""));
  EXPECT_THAT(told({R"({"budget":500})", R"({"budget":500,"sight":1})"}), ElementsAre("sight none", "sight 1"));
  EXPECT_THAT(told({R"({"robot":{"name":"a","parameters":{"x":1}},"tables":"1"})",
                    R"({"robot":{"name":"b","parameters":{"x":2}},"tables":"2"})"}),
              ElementsAre("robot a", "robot b"));
  EXPECT_THAT(told({R"({"robot":{"name":"a","parameters":{"x":1,"y":1,"z":1}}})",
                    R"({"robot":{"name":"a","parameters":{"x":2,"y":2,"z":2}}})"}),
              ElementsAre("robot x 1, robot y 1, ...", "robot x 2, robot y 2, ..."));
  EXPECT_THAT(told({"[]", R"({"budget":1})"}), ElementsAre("", ""));
  const auto deep = [](int depth, const std::string& inner) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += R"({"a":)";
    return text + inner + std::string(static_cast<std::size_t>(depth), '}');
  };
  EXPECT_THAT(told({deep(5, "1"), deep(5, "2")}), ElementsAre("a a a {...}", "a a a {...}"));
  EXPECT_THAT(told({deep(100'000, "1"), deep(100'000, "2")}), ElementsAre("", ""));
}

TEST_F(AStore, TellsRacesOfOneWorldApart) {
  race("flood", {test::loop()});
  EXPECT_EQ(stored_mice(path(), {}).mice.front().apart, "");
  Rules rules;
  rules.budget = 999;
  race("flood", {test::loop()}, test::in_steps(rules));
  const StoredMice mice = stored_mice(path(), {});
  ASSERT_THAT(mice.mice, SizeIs(2));
  EXPECT_EQ(mice.mice[0].apart, "budget 1000");
  EXPECT_EQ(mice.mice[1].apart, "budget 999");
}

TEST_F(AStore, ListsAndExports) {
  race("flood,random");
  const StoredMice mice = stored_mice(path(), {});
  ASSERT_THAT(mice.mice, SizeIs(2));
  EXPECT_EQ(mice.mice[1].mouse, "random");
  EXPECT_EQ(mice.mice[1].contests, 60);
  EXPECT_EQ(mice.mice[1].mazes, 3);
  std::string lines, csv;
  EXPECT_EQ(export_store(path(), {{}, {"flood"}, {"loop"}, {}, {}}, ExportFormat::json_lines, 0,
                         [&](const std::string& part) { return lines += part, true; }),
            "");
  const ReadJson json = ReadJson::parse(lines);
  EXPECT_EQ(json["maze"], "loop");
  EXPECT_EQ(json["fields"]["search_steps"].is_number_integer(), true);
  EXPECT_FALSE(json["fields"].contains("microseconds_per_decision"));
  EXPECT_EQ(export_store(path(), {}, ExportFormat::csv, 7, [&](const std::string& part) { return csv += part, true; }),
            "");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 8);
}

TEST_F(AStore, IsVerifiedByHoldingContestsAgain) {
  race(three_mice);
  const Verification good = verify_store(path(), {}, {1.0});
  EXPECT_EQ(good.held, static_cast<std::int64_t>(contests_of_three));
  EXPECT_EQ(good.equal, good.held);
  EXPECT_THAT(good.differences, IsEmpty());
  EXPECT_LT(verify_store(path(), {}, {0.3}).held, good.held);
  change("UPDATE timings SET figures = '[0.5]'");
  EXPECT_EQ(verify_store(path(), {}, {1.0}).equal, good.held);
  for (const char* difference : {"score = 3.5", "outcome = 'x'", "ratio = 9", "figures = '[7' || substr(figures, 3)"}) {
    change(std::string("UPDATE contests SET ") + difference + " WHERE id = 2");
    const Verification bad = verify_store(path(), {}, {1.0});
    EXPECT_THAT(bad.differences, SizeIs(1)) << difference;
    change("DELETE FROM contests WHERE id = 2; DELETE FROM timings WHERE contest = 2");
    race(three_mice);
    change("UPDATE contests SET id = 2 WHERE id = (SELECT max(id) FROM contests)");
    change("UPDATE timings SET contest = 2 WHERE contest = (SELECT max(contest) FROM timings)");
  }
  change("UPDATE mice SET text = replace(text, 'signature ', 'signature 0') WHERE name = 'flood'");
  EXPECT_EQ(verify_store(path(), {}, {1.0}).impossible, 3);
}

// Versions.

TEST_F(AStore, OfALaterVersionIsNotTouched) {
  race("flood", {test::loop()});
  change("PRAGMA user_version = 2");
  EXPECT_THAT(Store(path()).finish(), Says("results.db", "2", "1"));
  EXPECT_TRUE(Store(path()).failed());
  EXPECT_THAT(stored_mice(path(), {}).error, HasSubstr("results.db"));
  EXPECT_EQ(Database(path(), Access::read).number("PRAGMA user_version"), 2);
}

TEST_F(AStore, OfAnEarlierVersionIsBroughtToThePresentOne) {
  race("flood", {test::loop()});
  const std::vector<const char*> steps = {migrations()[0], "ALTER TABLE contests ADD COLUMN note TEXT",
                                          "UPDATE contests SET note = 'moved'"};
  EXPECT_NE(open_store(path(), Access::read, steps).error(), "");
  for (int i = 0; i < 2; ++i) {
    Database database = open_store(path(), Access::write, steps);
    EXPECT_EQ(database.error(), "");
    EXPECT_EQ(database.number("PRAGMA user_version"), 3);
    EXPECT_EQ(database.number("SELECT count(*) FROM contests WHERE note = 'moved'"), 1);
  }
}

TEST_F(AStore, StaysAsItWasWhereItCannotBeBroughtToThePresentVersion) {
  race("flood", {test::loop()});
  const std::vector<const char*> steps = {migrations()[0], "ALTER TABLE contests ADD COLUMN note TEXT",
                                          "UPDATE nothing SET note = 'moved'"};
  EXPECT_NE(open_store(path(), Access::write, steps).error(), "");
  EXPECT_EQ(number("PRAGMA user_version"), 1);
  EXPECT_EQ(number("SELECT count(*) FROM pragma_table_info('contests') WHERE name = 'note'"), 0);
  race("flood", {test::loop()});
  EXPECT_EQ(held_, 0U);
}

TEST_F(AStore, OfTheFirstVersionIsReadForEver) {
  std::ifstream file(fs::path(LABMOUSE_SOURCE_DIR) / "tests/data/store/version-1.sql");
  const std::string sql(std::istreambuf_iterator<char>(file), {});
  {
    Database database(path(), Access::create);
    database.run(sql);
    ASSERT_EQ(database.error(), "");
  }
  const StoredMice before = stored_mice(path(), {});
  EXPECT_EQ(Store(path()).finish(), "");
  const StoredMice mice = stored_mice(path(), {});
  ASSERT_THAT(mice.mice, SizeIs(3)) << mice.error;
  EXPECT_EQ(mice.mice[0].contests, 1);
  EXPECT_EQ(number("SELECT count(*) FROM pragma_integrity_check WHERE integrity_check <> 'ok'"), 0);
}

TEST_F(AStore, IsMadeOnceWhereTwoMakeIt) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) threads.emplace_back([&] { EXPECT_EQ(Store(path()).finish(), ""); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(number("PRAGMA user_version"), 1);
}

// What is no store, or a bad one.

TEST_F(AStore, IsNoOtherFile) {
  std::ofstream(path("text")) << "not a database" << std::string(4096, '.');
  EXPECT_THAT(Store(path("text")).finish(), HasSubstr("text: error: "));
  EXPECT_THAT(Store(folder_.string()).finish(), HasSubstr(": error: "));
  EXPECT_THAT(Store("/dev/full").finish(), HasSubstr("/dev/full: error: "));
  EXPECT_THAT(Store(path("none/results.db")).finish(), HasSubstr("none/results.db: error: "));
  EXPECT_THAT(Store("").finish(), HasSubstr("error: "));
  { Database(path("other.db"), Access::create).run("CREATE TABLE things (name TEXT)"); }
  EXPECT_THAT(Store(path("other.db")).finish(), HasSubstr("other.db: error: "));
  EXPECT_EQ(Database(path("other.db"), Access::read).number("SELECT count(*) FROM sqlite_master"), 1);
  EXPECT_THAT(stored_mice(path("missing.db"), {}).error, HasSubstr("missing.db: error: "));
  EXPECT_FALSE(fs::exists(path("missing.db")));
  std::ofstream(path("empty.db")).flush();
  EXPECT_THAT(stored_mice(path("empty.db"), {}).error, HasSubstr("empty.db: error: "));
  EXPECT_EQ(Store(path("empty.db")).finish(), "");
}

TEST_F(AStore, HasNothingInItsSchemaThatIsNotOfLabmouse) {
  const std::vector<std::pair<std::string, std::string>> foreign = {
      {"CREATE TRIGGER t AFTER INSERT ON contests BEGIN DELETE FROM mice; END", "trigger t"},
      {"CREATE VIEW v AS SELECT * FROM contests", "view v"},
      {"CREATE TABLE other (x)", "table other"},
      {"CREATE INDEX i ON mice (name)", "index i"},
      {"DROP VIEW results; CREATE VIEW results AS SELECT 1 AS id", "view results"},
      {"DROP VIEW pairs", "view pairs"}};
  for (const auto& [change, name] : foreign) {
    race("flood", {test::loop()}, test::in_steps(), "whole.db");
    fs::copy_file(path("whole.db"), path(), fs::copy_options::overwrite_existing);
    Database(path(), Access::write).run(change);
    EXPECT_THAT(Store(path()).finish(), Says("results.db", name));
    EXPECT_THAT(stored_mice(path(), {}).error, Says("results.db", name));
    EXPECT_THAT(verify_store(path(), {}, {}).error, Says("results.db", name));
    EXPECT_THAT(forget(path(), {}).error, Says("results.db", name));
    EXPECT_THAT(merge_stores({path("whole.db")}, path()).error, Says("results.db", name));
    EXPECT_THAT(merge_stores({path()}, path("whole.db")).error, Says("results.db", name));
  }
}

TEST_F(AStore, MayHaveStatisticsOfSqlite) {
  race("flood", {test::loop()});
  Database(path(), Access::write).run("ANALYZE");
  EXPECT_EQ(Store(path()).finish(), "");
  EXPECT_EQ(number("SELECT count(*) FROM sqlite_master WHERE name = 'sqlite_stat1'"), 1);
}

TEST_F(AStore, RunsNothingThatItsFileSays) {
  {
    Database database(path(), Access::create);
    database.run("CREATE TABLE a (x); CREATE TABLE b (x)");
    database.run("CREATE TRIGGER t AFTER INSERT ON a BEGIN INSERT INTO b VALUES (1); END");
  }
  Database database(path(), Access::write);
  EXPECT_EQ(database.number("PRAGMA trusted_schema"), 0);
  database.run("INSERT INTO a VALUES (1)");
  EXPECT_EQ(database.number("SELECT count(*) FROM b"), 0);
  database.run("PRAGMA writable_schema = ON; DELETE FROM sqlite_master");
  EXPECT_NE(database.error(), "");
}

TEST_F(AStore, IsCheckedBeforeARaceGoesOn) {
  constexpr std::size_t page = 4096, header = 100;
  race(three_mice);
  fs::copy_file(path(), path("holed.db"));
  {
    // The last page is of rows or of an index: what its header says is there no more.
    std::fstream file(path("holed.db"), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(fs::file_size(path()) - page + header));
    file << std::string(page - header, '\0');
  }
  EXPECT_THAT(Store(path("holed.db")).finish(), Says("holed.db", "damaged"));
  EXPECT_THAT(merge_stores({path()}, path("holed.db")).error, Says("holed.db", "damaged"));
  EXPECT_THAT(merge_stores({path("holed.db")}, path()).error, Says("holed.db", "damaged"));
  EXPECT_THAT(forget(path("holed.db"), {}).error, Says("holed.db", "damaged"));
}

TEST_F(AStore, MayHaveSeedsThatNoRaceHas) {
  race("flood");
  for (const char* seed : {"", "x", "-1", "18446744073709551616"}) {
    change(std::string("UPDATE contests SET race_seed = '") + seed + "'");
    EXPECT_THAT(stored_races(path(), {}).error, Says("damaged")) << seed;
    EXPECT_THAT(all_stored_contests(path(), {}).error, Says("damaged")) << seed;
  }
}

TEST_F(AStore, MayHaveParametersThatNoMouseHas) {
  race("flood");
  for (const char* parameters : {"", "[]", "null", "{"}) {
    change(std::string("UPDATE mice SET parameters = '") + parameters + "'");
    EXPECT_THAT(stored_races(path(), {}).error, Says("damaged")) << parameters;
  }
}

TEST_F(AStore, SaysThatItIsDamaged) {
  race(three_mice);
  const auto whole = fs::file_size(path());
  fs::copy_file(path(), path("cut.db"));
  fs::resize_file(path("cut.db"), whole / 2);
  EXPECT_THAT(Store(path("cut.db")).finish(), HasSubstr("cut.db: error: "));
  EXPECT_THAT(stored_mice(path("cut.db"), {}).error, HasSubstr("cut.db: error: "));
  fs::copy_file(path(), path("holed.db"));
  {
    std::fstream file(path("holed.db"), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(4096);
    file << std::string(static_cast<std::size_t>(whole) - 4096, '\x5a');
  }
  held_ = 0;
  const auto store = std::make_shared<Store>(path("holed.db"));
  RaceOrder order = test::in_steps();
  order.store = store;
  EXPECT_TRUE(hold_race(counted_mice("flood"), {test::loop()}, order).stopped);
  EXPECT_THAT(store->finish(), HasSubstr("holed.db: error: "));
  EXPECT_EQ(held_, 0U);
  EXPECT_THAT(verify_store(path("holed.db"), {}, {}).error, HasSubstr("holed.db: error: "));
}

TEST_F(AStore, IsNeverReadWithoutWhatADamagedPageHeld) {
  constexpr std::size_t page = 4096, header = 100;
  race(three_mice);
  const auto text_of = [](const std::string& file) {
    std::string text, error = export_store(file, {}, ExportFormat::csv, 0, [&](const std::string&lines) {
                        text += lines;
                        return true;
                      });
    return std::pair(text, error);
  };
  const auto whole = text_of(path());
  const std::size_t mice = stored_mice(path(), {}).mice.size();
  for (std::size_t at = page; at < fs::file_size(path()); at += page) {
    // The pages of SQLite begin with what is there; what they say of it may be gone.
    fs::copy_file(path(), path("holed.db"), fs::copy_options::overwrite_existing);
    {
      std::fstream file(path("holed.db"), std::ios::in | std::ios::out | std::ios::binary);
      file.seekp(static_cast<std::streamoff>(at + header));
      file << std::string(page - header, '\0');
    }
    const auto listed = stored_mice(path("holed.db"), {});
    EXPECT_TRUE(!listed.error.empty() || listed.mice.size() == mice) << at;
    const auto exported = text_of(path("holed.db"));
    EXPECT_TRUE(!exported.second.empty() || exported == whole) << at;
    EXPECT_NE(stored_races(path("holed.db"), {}).error.empty(), listed.error != "") << at;
  }
}

TEST_F(AStore, SaysWhatIsWrongWithItsRows) {
  race("flood", {test::loop()});
  change("UPDATE contests SET figures = '{'");
  EXPECT_THAT(stored_races(path(), {}).error, HasSubstr("results.db: error: "));
  race("flood", {test::loop()});
  EXPECT_EQ(held_, 1U);
  change("DELETE FROM mice");
  EXPECT_THAT(verify_store(path(), {}, {}).error, HasSubstr("results.db: error: "));
}

TEST_F(AStore, FindsWhatWasLeftInTheLogBesideIt) {
  race("flood", {test::loop()}, test::in_steps(), "other.db");
  {
    Database database = open("other.db");
    database.run("PRAGMA wal_autocheckpoint = 0");
    database.run("UPDATE contests SET outcome = 'from the log'");
    // As a crash leaves them: the main file without what is in the log.
    fs::copy_file(path("other.db"), path());
    fs::copy_file(path("other.db") + "-wal", path() + "-wal");
  }
  EXPECT_EQ(number("SELECT count(*) FROM contests WHERE outcome = 'from the log'"), 1);
}

/// What another user may do, where the tests run as root, for whom every file can be written.
class AnotherUser {
 public:
  AnotherUser() : was_(geteuid()) {
    if (was_ == 0 && seteuid(65534) != 0) std::abort();
  }
  AnotherUser(const AnotherUser&) = delete;
  AnotherUser& operator=(const AnotherUser&) = delete;
  ~AnotherUser() {
    if (was_ == 0 && seteuid(0) != 0) std::abort();
  }

 private:
  uid_t was_;
};

TEST_F(AStore, ThatCannotBeWrittenIsReadOnly) {
  race("flood", {test::loop()});
  fs::permissions(path(), fs::perms(0444));
  fs::permissions(folder_, fs::perms(0555));
  {
    const AnotherUser user;
    EXPECT_THAT(Store(path()).finish(), HasSubstr("results.db: error: cannot be written"));
    EXPECT_THAT(Store(path("new.db")).finish(), HasSubstr("new.db: error: cannot be "));
    EXPECT_THAT(stored_mice(path(), {}).mice, SizeIs(1));
    EXPECT_THAT(stored_races(path(), {}).races, SizeIs(1));
  }
  fs::permissions(folder_, fs::perms(0755));
  {
    const AnotherUser user;
    EXPECT_THAT(Store(path()).finish(), HasSubstr("results.db: error: cannot be written"));
    EXPECT_THAT(stored_mice(path(), {}).mice, SizeIs(1));
  }
}

/// Whoever walks such a text by recursion ends.
TEST_F(AStore, WithEndlesslyNestedTextsIsShownAndRefused) {
  constexpr int deep = 300'000;
  const std::string lists = std::string(deep, '[') + std::string(deep, ']');
  std::string objects;
  for (int i = 0; i < deep; ++i) objects += "{\"name\":";
  objects += "1" + std::string(deep, '}');
  for (const char* column :
       {"contests.fields", "contests.figures", "worlds.conditions", "mice.about", "mice.parameters"})
    for (const std::string& text : {lists, objects}) {
      SCOPED_TRACE(column);
      fs::remove(path());
      race("flood", {test::loop()});
      const std::string name = column;
      change("UPDATE " + name.substr(0, name.find('.')) + " SET " + name.substr(name.find('.') + 1) + " = '" + text +
             "'");
      std::size_t lines = 0;
      EXPECT_EQ(export_store(path(), {}, ExportFormat::json_lines, 0,
                             [&](const std::string& part) { return lines += part.size(), true; }),
                "");
      EXPECT_GT(lines, 0U);
      EXPECT_THAT(stored_mice(path(), {}).mice, SizeIs(1));
      stored_races(path(), {});
      verify_store(path(), {}, {1.0});
    }
}

TEST(Json, IsNotReadWhereItIsTooDeep) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_TRUE(read_json(nested(30)).is_array());
  EXPECT_TRUE(read_json(nested(1'000'000)).is_discarded());
  EXPECT_TRUE(read_ordered_json(nested(30)).is_array());
  EXPECT_TRUE(read_ordered_json(nested(1'000'000)).is_discarded());
  EXPECT_TRUE(read_json("no JSON").is_discarded());
  // Brackets in texts, and marks of quotation in those, are none.
  EXPECT_FALSE(is_too_deep("\"" + std::string(100, '[') + "\""));
  EXPECT_FALSE(is_too_deep(R"(["\"[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[["])"));
  std::string many = "[";
  for (int i = 0; i < 1000; ++i) many += "[],";
  EXPECT_FALSE(is_too_deep(many + "[]]"));
}

// Worlds.

TEST_F(AStore, MakesWorldsAgainFromTheirConditions) {
  for (const WorldEntry* entry : all_worlds()) {
    const auto world = entry->make({}).world;
    const auto again = restore_world(entry->name, conditions_text(*world));
    ASSERT_TRUE(again) << entry->name;
    EXPECT_EQ(key_of(*again), key_of(*world));
    for (const char* wrong :
         {"", "{}", "[]", "null", "{\"budget\":-1}", "{\"budget\":\"x\"}", "{\"rules\":1,\"robot\":{}}"})
      EXPECT_FALSE(restore_world(entry->name, wrong)) << entry->name << wrong;
  }
  EXPECT_FALSE(restore_world("elsewhere", "{}"));
  const auto half = find_world("seconds")->make({{"robot", "half"}, {"rules", "thirtieth"}}).world;
  EXPECT_EQ(key_of(*restore_world("seconds", conditions_text(*half))), key_of(*half));
}

}  // namespace
}  // namespace labmouse
