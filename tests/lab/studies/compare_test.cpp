// Sequential tests of mice: how often they are wrong, how soon they decide, and what they hold.
#include "labmouse/lab/studies/compare.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "labmouse/chance/rng.hpp"
#include "labmouse/external/hidden_files.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;
using Verdict = SequentialVerdict;

/// Comparisons in small generated mazes.
CompareOrder in_small_mazes(std::size_t most = 2000) {
  CompareOrder order;
  order.race = test::in_steps();
  order.mazes.generator = &prim_generator;
  order.mazes.order = {{5, 5}, 1, 100};
  order.most = most;
  return order;
}

/// Shares of the best possible score of a mouse with dice in many small mazes, several in each.
std::vector<std::vector<double>> shares_of(std::string_view spec, int runs) {
  const MazeSource mazes = in_small_mazes().mazes;
  std::vector<NamedMaze> some;
  for (std::size_t i = 0; i < 40; ++i) some.push_back(drawn_maze(mazes, 1, i));
  RaceOrder order = test::in_steps();
  order.runs = runs;
  const Race race = hold_race(test::mice(spec), some, order);
  std::vector<std::vector<double>> shares(some.size());
  for (const ContestResult& contest : race.results)
    shares[contest.maze].push_back(contest.ratio ? 1.0 / *contest.ratio : 0.0);
  return shares;
}

struct Counted {
  int better = 0, worse = 0, none = 0, undecided = 0;
  double mazes = 0.0;  ///< mean number of mazes
};

/// Tests two mice again and again, each time in mazes and with contests drawn at random from those that were held.
Counted counted_tests(const std::vector<std::vector<double>>& one, const std::vector<std::vector<double>>& other,
                      const SequentialOrder& order, int tests, int most) {
  Counted counted;
  for (int i = 0; i < tests; ++i) {
    Rng rng(seed_for(3, "test", static_cast<std::uint64_t>(i)));
    SequentialTest test(order);
    const auto any = [&](const std::vector<double>& list) {
      return list[static_cast<std::size_t>(rng.below(static_cast<int>(list.size())))];
    };
    for (int j = 0; j < most && test.verdict() == Verdict::undecided; ++j) {
      const auto maze = static_cast<std::size_t>(rng.below(static_cast<int>(one.size())));
      test.add(any(one[maze]) - any(other[maze]));
    }
    counted.mazes += static_cast<double>(test.differences().size()) / tests;
    ++(test.verdict() == Verdict::better          ? counted.better
       : test.verdict() == Verdict::worse         ? counted.worse
       : test.verdict() == Verdict::no_difference ? counted.none
                                                  : counted.undecided);
  }
  return counted;
}

double mean_of(const std::vector<std::vector<double>>& shares) {
  double sum = 0.0, count = 0.0;
  for (const std::vector<double>& maze : shares)
    for (const double share : maze) {
      sum += share;
      count += 1.0;
    }
  return sum / count;
}

TEST(SequentialTest, IsSeldomWrongAboutEqualMice) {
  LABMOUSE_SKIP_SANITIZED();
  const auto shares = shares_of("random-move", 40);
  SequentialOrder order;
  order.better_by = 0.05;
  const int tests = 10'000;
  const Counted counted = counted_tests(shares, shares, order, tests, 400);
  EXPECT_LE(counted.better + counted.worse, 0.05 * tests);
  RecordProperty("wrong", counted.better + counted.worse);
}

TEST(SequentialTest, FindsDifferencesThatThereAre) {
  LABMOUSE_SKIP_SANITIZED();
  const auto better = shares_of("flood", 1), worse = shares_of("random", 40);
  const double difference = mean_of(better) - mean_of(worse);
  ASSERT_GT(difference, 0.1);
  SequentialOrder order;
  order.better_by = 0.05;
  const int tests = 1000;
  for (const SequentialMethod method : {SequentialMethod::bets, SequentialMethod::gsprt}) {
    order.method = method;
    const Counted counted = counted_tests(better, worse, order, tests, 400);
    EXPECT_GE(counted.better, 0.95 * tests);
    EXPECT_EQ(counted.worse, 0);
    EXPECT_GE(counted_tests(worse, better, order, tests, 400).worse, 0.95 * tests);
  }
  // A difference as large as the one that matters is seldom overlooked.
  order.better_by = difference;
  for (const SequentialMethod method : {SequentialMethod::bets, SequentialMethod::gsprt}) {
    order.method = method;
    EXPECT_LE(counted_tests(better, worse, order, tests, 400).none, 0.05 * tests);
  }
}

TEST(SequentialTest, FindsThatThereIsNoDifferenceThatMatters) {
  LABMOUSE_SKIP_SANITIZED();
  const auto shares = shares_of("random-move", 40);
  SequentialOrder order;
  order.better_by = 0.2;
  for (const SequentialMethod method : {SequentialMethod::bets, SequentialMethod::gsprt}) {
    order.method = method;
    const Counted counted = counted_tests(shares, shares, order, 1000, 1000);
    EXPECT_GE(counted.none, 900);
    EXPECT_LE(counted.better + counted.worse, 60);
  }
}

/// Prints the table of docs/research/README.md.
TEST(SequentialTest, HasTheErrorRatesOfTheTable) {
  if (!test::thorough) return;
  const int tests = 10'000, most = 2000;
  std::fputs("mice | difference | test | better | worse | no difference | undecided | mazes\n", stdout);
  for (const auto& [first, other] :
       {std::pair("random-move", "random-move"), std::pair("random", "random-move"),
        std::pair("flood", "flood:stride=1"), std::pair("flood", "certify"), std::pair("dead-end", "flood")}) {
    const auto one = shares_of(other, 40), before = shares_of(first, 40);
    const double difference = mean_of(one) - mean_of(before);
    for (const SequentialMethod method : {SequentialMethod::bets, SequentialMethod::gsprt}) {
      SequentialOrder order;
      order.better_by = 0.05;
      order.method = method;
      const Counted counted = counted_tests(one, before, order, tests, most);
      const auto percent = [&](int count) { return 100.0 * count / tests; };
      std::fputs(
          fmt::format("{} against {} | {:+.3f} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.0f}\n", other, first,
                      difference, method == SequentialMethod::bets ? "bets" : "gsprt", percent(counted.better),
                      percent(counted.worse), percent(counted.none), percent(counted.undecided), counted.mazes)
              .c_str(),
          stdout);
      if (method == SequentialMethod::gsprt) continue;
      if (difference <= 0.0) {
        EXPECT_LE(percent(counted.better), 5.0);
      }
      if (difference >= 0.0) {
        EXPECT_LE(percent(counted.worse), 5.0);
      }
      if (std::abs(difference) >= order.better_by) {
        EXPECT_LE(percent(counted.none), 5.0);
      }
    }
  }
}

/// So many times that difference until the wealth against means of at most `bar` reaches that.
std::size_t count_until(double bar, double difference, double needed) {
  WealthProcess process(bar);
  std::size_t count = 0;
  for (; process.wealth() < needed; ++count) process.add(difference);
  return count;
}

TEST(SequentialTest, DecidesWhenTheWealthReachesWhatItsErrorsAllow) {
  const SequentialOrder order = {.better_by = 0.1, .alpha = 0.04, .beta = 0.1};
  const auto count_of = [&](double difference, Verdict verdict) {
    SequentialTest test(order);
    while (test.verdict() == Verdict::undecided) test.add(difference);
    EXPECT_EQ(test.verdict(), verdict);
    return test.differences().size();
  };
  EXPECT_EQ(count_of(0.3, Verdict::better), count_until(0.0, 0.3, 50.0));
  EXPECT_EQ(count_of(-0.3, Verdict::worse), count_until(0.0, 0.3, 50.0));
  EXPECT_EQ(count_of(0.0, Verdict::no_difference), count_until(-0.1, 0.0, 10.0));
  // Close to one of the two, the other is refuted long before.
  EXPECT_EQ(count_of(0.01, Verdict::no_difference), count_until(-0.1, -0.01, 10.0));
}

/// As after the mending of a bug: most mazes are as before.
TEST(SequentialTest, SeldomOverlooksRareDifferences) {
  SequentialOrder order;
  order.better_by = 0.05;
  for (const SequentialMethod method : {SequentialMethod::bets, SequentialMethod::gsprt})
    for (const auto& [share, difference] : {std::pair(20, 1.0), std::pair(10, 0.5), std::pair(16, 0.8)}) {
      order.method = method;
      int overlooked = 0;
      for (int i = 0; i < 1000; ++i) {
        Rng rng(seed_for(9, "rare", static_cast<std::uint64_t>(i)));
        SequentialTest test(order);
        for (int j = 0; j < 3000 && test.verdict() == Verdict::undecided; ++j)
          test.add(rng.below(share) == 0 ? difference : 0.0);
        overlooked += test.verdict() == Verdict::no_difference ? 1 : 0;
      }
      EXPECT_LE(overlooked, method == SequentialMethod::bets ? 50 : 80) << share;
    }
}

TEST(SequentialTest, KnowsTheLargestDifferencesThatThereAre) {
  SequentialTest test({.better_by = most_better_by});
  while (test.verdict() == Verdict::undecided) test.add(1.0);
  EXPECT_EQ(test.verdict(), Verdict::better);
}

TEST(SequentialTest, KeepsItsVerdict) {
  SequentialTest test({.better_by = 0.1});
  while (test.verdict() == Verdict::undecided) test.add(0.8);
  const std::size_t count = test.differences().size();
  EXPECT_EQ(test.verdict(), Verdict::better);
  EXPECT_LT(count, 20U);
  for (int i = 0; i < 100; ++i) test.add(-1.0);
  EXPECT_EQ(test.verdict(), Verdict::better);
  EXPECT_EQ(test.differences().size(), count);
  EXPECT_NEAR(test.mean(), 0.8, 1e-12);
  EXPECT_GT(test.interval().low, 0.0);
}

TEST(Compare, DecidesBetweenMiceAndSaysBy) {
  CompareOrder order = in_small_mazes();
  order.test.better_by = 0.02;
  const Compared compared = hold_comparison(test::mice("random,flood,certify"), order);
  EXPECT_EQ(compared.first, "random");
  ASSERT_THAT(compared.candidates, SizeIs(2));
  for (const ComparedMouse& candidate : compared.candidates) {
    EXPECT_EQ(candidate.verdict, Verdict::better) << candidate.mouse;
    EXPECT_GT(candidate.interval.low, 0.0);
    EXPECT_NEAR(candidate.difference, candidate.share - candidate.first_share, 1e-12);
    EXPECT_LE(candidate.pairs, compared.mazes);
  }
  EXPECT_FALSE(compared.exact);
  EXPECT_LT(compared.mazes, order.most);
  EXPECT_EQ(compared.skipped, 0U);
}

TEST(Compare, IsTheSameOnAnyNumberOfThreads) {
  CompareOrder order = in_small_mazes(200);
  order.race.jobs = 1;
  const std::string one = json_of(hold_comparison(test::mice("random,random-move"), order));
  order.race.jobs = 3;
  EXPECT_EQ(json_of(hold_comparison(test::mice("random,random-move"), order)), one);
  order.race.seed = 2;
  EXPECT_NE(json_of(hold_comparison(test::mice("random,random-move"), order)), one);
}

TEST(Compare, IsExactInAListWithoutDice) {
  CompareOrder order = in_small_mazes();
  order.mazes.list = {test::loop(), test::corridor(), test::without_route()};
  const Compared compared = hold_comparison(test::mice("flood,certify,flood:stride=1"), order);
  EXPECT_TRUE(compared.exact);
  EXPECT_EQ(compared.mazes, 3U);
  EXPECT_EQ(compared.skipped, 1U);
  const Race race = hold_race(test::mice("flood,certify"), order.mazes.list, test::in_steps());
  double difference = 0.0;
  for (const ContestResult& contest : race.results)
    if (contest.ratio) difference += (race.mice[contest.mouse].name == "certify" ? 0.5 : -0.5) / *contest.ratio;
  const ComparedMouse& certify = compared.candidates.front();
  EXPECT_NEAR(certify.difference, difference, 1e-12);
  EXPECT_EQ(certify.verdict, difference > 0.0   ? Verdict::better
                             : difference < 0.0 ? Verdict::worse
                                                : Verdict::no_difference);
  EXPECT_EQ(certify.interval, (Interval{certify.difference, certify.difference}));
  // With dice the mazes are drawn, more often than there are.
  const Compared drawn = hold_comparison(test::mice("flood,random"), order);
  EXPECT_FALSE(drawn.exact);
  EXPECT_GT(drawn.mazes, 3U);
  EXPECT_GT(drawn.skipped, 0U);
}

TEST(Compare, IsNotExactWithChanceWhateverAMouseSaysOfItsRuns) {
  CompareOrder order = in_small_mazes(64);
  order.mazes.list = {test::loop(), test::corridor()};
  std::vector<Contestant> mice = test::mice("random,random-move");
  for (Contestant& mouse : mice) mouse.runs = 5;
  const Compared compared = hold_comparison(mice, order);
  EXPECT_FALSE(compared.exact);
  EXPECT_GT(compared.mazes, 2U);
  order.race.world = find_world("physical")->make({}).world;
  order.most = 4;
  EXPECT_FALSE(hold_comparison(test::mice("flood,flood-return"), order).exact);
}

TEST(Compare, EndsWhereNoMazeCounts) {
  CompareOrder order = in_small_mazes();
  order.race.world = find_world("seconds")->make({{"rules", "coverage"}}).world;
  for (const bool listed : {false, true}) {
    if (listed) order.mazes.list = {test::loop()};
    const Compared compared = hold_comparison(test::mice("flood,certify"), order);
    EXPECT_EQ(compared.candidates.front().verdict, Verdict::undecided);
    EXPECT_EQ(compared.candidates.front().pairs, 0U);
    EXPECT_EQ(compared.skipped, compared.mazes);
    EXPECT_LE(compared.mazes, 32U);
    EXPECT_THAT(table_of(compared), Not(HasSubstr("exact")));
  }
}

TEST(Compare, SkipsMazesThatItsWorldRefuses) {
  CompareOrder order = in_small_mazes(40);
  order.race.world = find_world("seconds")->make({}).world;
  order.mazes.order.size = {40, 40};
  const Compared compared = hold_comparison(test::mice("flood,certify"), order);
  EXPECT_EQ(compared.mazes, 32U);
  EXPECT_EQ(compared.skipped, 32U);
}

TEST(Compare, HidesItsListFromExternalMiceAndNothingThatIsNoFile) {
  const std::string path = testing::TempDir() + "compared-maze.txt";
  std::ofstream(path) << drawing_format.write(test::corridor().maze).content.value();
  CompareOrder order = in_small_mazes(2);
  order.mazes.list = {{path, test::corridor().maze}};
  const std::vector<Contestant> mice = test::mice("flood,it=program:false");
  hold_comparison(mice, order);
  const HiddenFiles::Paths hidden = mice[1].hidden->paths();
  EXPECT_THAT(*hidden, Contains(path));
  EXPECT_THAT(*hidden, Each(Not(HasSubstr("0000000-"))));
  std::filesystem::remove(path);
}

/// External mice that draw lots by their seeds would otherwise draw the same ones in a whole batch.
TEST(Compare, TellsExternalMiceAnotherSeedInEachMaze) {
  RaceOrder order = test::in_steps();
  order.first_told = 7;
  const Race race = hold_race(test::mice("flood"), {test::loop(), test::corridor()}, order);
  EXPECT_EQ(race.results[0].told, seed_of_program(7, 0));
  EXPECT_EQ(race.results[1].told, seed_of_program(8, 0));
  EXPECT_NE(race.results[0].told, race.results[1].told);
}

TEST(Compare, GoesOnWithoutWhatIsDecided) {
  CompareOrder order = in_small_mazes();
  order.test.better_by = 0.02;
  const Compared compared = hold_comparison(test::mice("flood,random,certify"), order);
  EXPECT_EQ(compared.candidates[0].verdict, Verdict::worse);
  EXPECT_NE(compared.candidates[1].verdict, Verdict::undecided);
  EXPECT_LT(compared.candidates[0].pairs, compared.candidates[1].pairs);
  EXPECT_EQ(compared.candidates[1].pairs, compared.mazes);
}

TEST(Compare, EndsUndecidedWhereItMayNotGoOn) {
  const Compared compared = hold_comparison(test::mice("random,random-move"), in_small_mazes(40));
  EXPECT_EQ(compared.candidates.front().verdict, Verdict::undecided);
  EXPECT_EQ(compared.mazes, 40U);
  EXPECT_THAT(table_of(compared), Says("random-move", "undecided", "40 mazes"));
  std::atomic<bool> stop{true};
  CompareHooks hooks;
  hooks.stop = &stop;
  const Compared stopped = hold_comparison(test::mice("random,random-move"), in_small_mazes(40), hooks);
  EXPECT_TRUE(stopped.stopped);
  EXPECT_EQ(stopped.mazes, 0U);
  EXPECT_TRUE(nlohmann::json::parse(json_of(stopped))["stopped"]);
}

TEST(Compare, HasErrorRatesForAllCandidatesTogether) {
  const SequentialOrder each = order_of_each({.better_by = 0.01, .alpha = 0.06, .beta = 0.03}, 3);
  EXPECT_NEAR(each.alpha, 0.02, 1e-15);
  EXPECT_NEAR(each.beta, 0.01, 1e-15);
}

TEST(Compare, RacesInTimeAsWell) {
  CompareOrder order = in_small_mazes(16);
  order.race.world = find_world("physical")->make({}).world;
  order.test.better_by = 0.1;
  const Compared compared = hold_comparison(test::mice("flood-return,flood"), order);
  const ComparedMouse& flood = compared.candidates.front();
  EXPECT_GT(flood.pairs, 0U);
  EXPECT_GE(flood.share, 0.0);
  EXPECT_LE(flood.first_share, 1.0);
}

}  // namespace
}  // namespace labmouse
