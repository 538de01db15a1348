// A store of contests: what is there is not run again, and comes back as it was.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/store/stored_races.hpp"
#include "labmouse/lab/store/verification.hpp"
#include "labmouse/lab/studies/study.hpp"
#include "labmouse/lab/studies/sweep.hpp"
#include "labmouse/lab/studies/tune.hpp"
#include "tests/lab/store/store_fixture.hpp"

namespace labmouse {
namespace {

using test::AStore;
using test::contests_of_three;
using test::three_mice;
using test::without_timings;
using ::testing::IsEmpty;

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
    table = table_of(hold_sweep("flood", read_swept_values("stride=1:3:1"), mazes, order), false);
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

}  // namespace
}  // namespace labmouse
