// The rows and views of a store, and what is printed of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/store/differences.hpp"
#include "labmouse/lab/store/schema.hpp"
#include "labmouse/lab/store/stored_races.hpp"
#include "labmouse/lab/store/verification.hpp"
#include "tests/lab/store/store_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::AStore;
using test::contests_of_three;
using test::Says;
using test::three_mice;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

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

}  // namespace
}  // namespace labmouse
