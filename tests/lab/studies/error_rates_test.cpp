// How often sequential tests are wrong where that is hardest: on simulated differences, at the boundary of what they
// test, with tiny differences that matter, looked at after each contest, and with several candidates.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "labmouse/chance/rng.hpp"
#include "labmouse/lab/studies/compare.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using Verdict = SequentialVerdict;

/// Differences of two shares: `size` with that probability, in 1/1000, upwards and downwards, 0 otherwise.
struct Differences {
  const char* name;
  double size;
  int up, down;

  double mean() const { return size * (up - down) / 1000.0; }
  double drawn(Rng& rng) const {
    const int number = rng.below(1000);
    return number < up ? size : number < up + down ? -size : 0.0;
  }
};

struct Rates {
  int better = 0, worse = 0, none = 0;
};

/// Tests again and again. Each test is looked at after each contest, and ends with its first verdict.
Rates rates_of(const Differences& differences, const SequentialOrder& order, int tests, int most) {
  Rates rates;
  for (int i = 0; i < tests; ++i) {
    Rng rng(seed_for(11, differences.name, static_cast<std::uint64_t>(i)));
    SequentialTest test(order);
    for (int j = 0; j < most && test.verdict() == Verdict::undecided; ++j) test.add(differences.drawn(rng));
    rates.better += test.verdict() == Verdict::better ? 1 : 0;
    rates.worse += test.verdict() == Verdict::worse ? 1 : 0;
    rates.none += test.verdict() == Verdict::no_difference ? 1 : 0;
  }
  return rates;
}

// Means of 0, and of 0.02, which is as large as the difference that matters.
constexpr Differences equal_often = {"equal, in half of the mazes", 1.0, 250, 250};
constexpr Differences equal_always = {"equal, in each maze", 0.2, 500, 500};
constexpr Differences equal_seldom = {"equal, in 2 % of the mazes", 1.0, 10, 10};
constexpr Differences equal_skewed = {"equal but for many small steps", 0.5, 30, 30};
constexpr Differences bar_often = {"0.02, in half of the mazes", 0.2, 300, 200};
constexpr Differences bar_seldom = {"0.02, in 2 % of the mazes", 1.0, 20, 0};
constexpr Differences bar_downwards = {"-0.02, in half of the mazes", 0.2, 200, 300};

/// A tiny difference that matters never lets a test of equal mice end early with "no difference": it runs to its most
/// contests, and each of them is a chance to be wrong.
constexpr double tiny = 0.001;

int percent_of(int tests, int percent) { return tests * percent / 100; }

TEST(ErrorRates, HoldForEqualMiceWhereverATestMayStop) {
  LABMOUSE_SKIP_SANITIZED();
  const int tests = test::thorough ? 10'000 : 1000, most = test::thorough ? 5000 : 2000;
  if (test::thorough) std::fputs("differences | better-by | better or worse, %\n", stdout);
  for (const Differences& differences : {equal_often, equal_always, equal_seldom, equal_skewed}) {
    const SequentialOrder order = {.better_by = tiny};
    const Rates rates = rates_of(differences, order, tests, most);
    EXPECT_LE(rates.better + rates.worse, percent_of(tests, 5)) << differences.name;
    EXPECT_EQ(rates.none, 0) << differences.name;
    if (test::thorough)
      std::fputs(fmt::format("{} | {} | {:.2f}\n", differences.name, tiny, 100.0 * (rates.better + rates.worse) / tests)
                     .c_str(),
                 stdout);
  }
}

TEST(ErrorRates, HoldForDifferencesThatJustMatter) {
  LABMOUSE_SKIP_SANITIZED();
  const int tests = test::thorough ? 10'000 : 400, most = test::thorough ? 5000 : 2000;
  if (test::thorough) std::fputs("differences | better-by | no difference, % | wrong direction, %\n", stdout);
  for (const Differences& differences : {bar_often, bar_seldom, bar_downwards}) {
    const SequentialOrder order = {.better_by = 0.02};
    const Rates rates = rates_of(differences, order, tests, most);
    const int wrong = differences.mean() > 0.0 ? rates.worse : rates.better;
    EXPECT_LE(rates.none, percent_of(tests, 5)) << differences.name;
    EXPECT_LE(wrong, percent_of(tests, 5)) << differences.name;
    if (test::thorough)
      std::fputs(fmt::format("{} | 0.02 | {:.2f} | {:.2f}\n", differences.name, 100.0 * rates.none / tests,
                             100.0 * wrong / tests)
                     .c_str(),
                 stdout);
  }
}

/// In how many families at least one of the candidates, which all equal the first mouse, is called better or worse.
/// All of them are compared with the same contests of the first mouse, so that their errors depend on each other.
int wrong_families(const SequentialOrder& order, int candidates, int families, int most) {
  int wrong = 0;
  for (int i = 0; i < families; ++i) {
    Rng rng(seed_for(12, "family", static_cast<std::uint64_t>(i)));
    std::vector<SequentialTest> tests(static_cast<std::size_t>(candidates), SequentialTest(order));
    bool is_wrong = false;
    for (int j = 0; j < most && !is_wrong; ++j) {
      const double first = rng.below(2);
      for (SequentialTest& test : tests) {
        test.add(rng.below(2) - first);
        is_wrong = is_wrong || test.verdict() == Verdict::better || test.verdict() == Verdict::worse;
      }
    }
    wrong += is_wrong ? 1 : 0;
  }
  return wrong;
}

TEST(ErrorRates, HoldForAllCandidatesTogether) {
  LABMOUSE_SKIP_SANITIZED();
  const int families = test::thorough ? 10'000 : 400, most = 1000;
  if (test::thorough) std::fputs("candidates | families with an error, % | without the correction, %\n", stdout);
  for (const int candidates : {2, 5, 10}) {
    const SequentialOrder order = {.better_by = tiny, .alpha = 0.2};
    const int wrong =
        wrong_families(order_of_each(order, static_cast<std::size_t>(candidates)), candidates, families, most);
    EXPECT_LE(wrong, percent_of(families, 20)) << candidates;
    if (test::thorough)
      std::fputs(fmt::format("{} | {:.2f} | {:.2f}\n", candidates, 100.0 * wrong / families,
                             100.0 * wrong_families(order, candidates, families, most) / families)
                     .c_str(),
                 stdout);
  }
}

}  // namespace
}  // namespace labmouse
