// Stores that are put together from shards or merged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "labmouse/lab/store/differences.hpp"
#include "labmouse/lab/store/store_changes.hpp"
#include "labmouse/lab/store/stored_races.hpp"
#include "labmouse/lab/store/verification.hpp"
#include "labmouse/lab/system/file_lock.hpp"
#include "tests/lab/store/store_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;
using test::AStore;
using test::contests_of_three;
using test::Says;
using test::three_mice;
using test::without_timings;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

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

}  // namespace
}  // namespace labmouse
