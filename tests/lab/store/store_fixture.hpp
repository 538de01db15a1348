// A folder for stores, and races that go through them.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/store/schema.hpp"
#include "labmouse/lab/store/store.hpp"
#include "tests/lab/races/race_fixture.hpp"

namespace labmouse::test {

/// A folder for stores that goes away with the test, and races that count the mice that were made for their contests.
class AStore : public testing::Test {
 protected:
  AStore() { std::filesystem::create_directories(folder_); }
  ~AStore() override { std::filesystem::remove_all(folder_); }

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
  Race race(std::string_view specs, std::vector<NamedMaze> mazes = {loop(), corridor(), without_route()},
            RaceOrder order = in_steps(), const std::string& name = "results.db") {
    held_ = 0;
    const auto store = std::make_shared<Store>(path(name));
    order.store = store;
    Race race = hold_race(counted_mice(specs), std::move(mazes), order);
    EXPECT_EQ(store->finish(), "");
    recalled_ = store->recalled();
    added_ = store->added();
    return race;
  }

  Database open(const std::string& name = "results.db") const {
    return open_store(path(name), Database::Access::write);
  }
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

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("labmouse-store-" + std::to_string(getpid()) + "-" +
                                                   testing::UnitTest::GetInstance()->current_test_info()->name());
  std::atomic<std::size_t> held_{0};
  std::size_t recalled_ = 0, added_ = 0;
};

inline constexpr const char* three_mice = "flood,certify,random";
inline constexpr std::size_t contests_of_three = 3 + 3 + 60;

/// A race without the figures that the clock makes.
inline std::string without_timings(Race race) {
  const StoredFigures& stored = race.world().traits().fields->figures;
  for (ContestResult& contest : race.results) {
    std::vector<Value> figures = stored.values_of(*contest.figures);
    for (std::size_t i = 0; i < figures.size(); ++i)
      if (stored.all[i].by_clock) figures[i] = Value(0.0);
    contest.figures = stored.figures_of(figures);
  }
  return json_of(race, {});
}

}  // namespace labmouse::test
