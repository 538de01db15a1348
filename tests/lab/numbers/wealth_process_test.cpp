#include "labmouse/lab/numbers/wealth_process.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "labmouse/chance/rng.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

double share(Rng& rng) { return rng.below(1 << 20) / static_cast<double>(1 << 20); }

/// Differences from -1 to 1 whose mean is known.
struct Draw {
  double mean;
  std::function<double(Rng&)> one;
};

const std::vector<Draw>& draws() {
  static const std::vector<Draw> all = {
      {0.0, [](Rng& rng) { return rng.below(2) == 0 ? -1.0 : 1.0; }},
      {0.0, [](Rng& rng) { return 0.02 * share(rng) - 0.01; }},
      // Skewed: mostly a little above, seldom far below, and the other way round.
      {0.0, [](Rng& rng) { return rng.below(20) == 0 ? -0.95 : 0.05; }},
      {0.0, [](Rng& rng) { return rng.below(20) == 0 ? 0.95 : -0.05; }},
      {0.2, [](Rng& rng) { return 0.2 + 0.4 * (share(rng) - 0.5); }},
  };
  return all;
}

TEST(WealthProcess, HasWhatItsStakesCameTo) {
  WealthProcess process(0.0);
  EXPECT_NEAR(process.wealth(), 1.0, 1e-12);
  process.add(0.5);
  process.add(-1.0);
  double expected = 0.0;
  for (int i = 1; i <= 10; ++i) {
    const double stake = std::exp2(-i);
    expected += (1.0 + 0.5 * stake) * (1.0 - stake) / 10.0;
  }
  EXPECT_NEAR(process.wealth(), expected, 1e-12);
  // Against a mean of at most -0.5 twice as much can be staked, because less can be lost.
  WealthProcess low(-0.5);
  low.add(0.5);
  expected = 0.0;
  for (int i = 1; i <= 10; ++i) expected += (1.0 + 2.0 * std::exp2(-i)) / 10.0;
  EXPECT_NEAR(low.wealth(), expected, 1e-12);
  // At a higher bar the worst that can come takes no more than all.
  WealthProcess high(0.5);
  for (int i = 0; i < 100; ++i) high.add(-1.0);
  EXPECT_GE(high.wealth(), 0.0);
  for (int i = 0; i < 100'000; ++i) process.add(1.0);
  EXPECT_TRUE(std::isfinite(process.wealth()));
}

TEST(WealthProcess, IsSeldomHighWhereTheBarIsTheMean) {
  const int series = test::fewer(20'000);
  for (std::size_t kind = 0; kind < draws().size(); ++kind) {
    int reached = 0;
    for (int i = 0; i < series; ++i) {
      Rng rng(seed_for(kind, "bets", static_cast<std::uint64_t>(i)));
      WealthProcess process(draws()[kind].mean);
      double most = 0.0;
      for (int j = 0; j < 300; ++j) {
        process.add(draws()[kind].one(rng));
        most = std::max(most, process.wealth());
      }
      reached += most >= 20.0 ? 1 : 0;
    }
    // At most one in twenty; four standard deviations beyond.
    EXPECT_LE(reached, 0.05 * series + 4.0 * std::sqrt(0.05 * 0.95 * series)) << kind;
  }
}

TEST(ConfidenceSequence, IsAllWithoutDifferences) { EXPECT_EQ(confidence_sequence({}, 0.05), (Interval{-1.0, 1.0})); }

TEST(ConfidenceSequence, EndsWhereAMeanIsRefuted) {
  Rng rng(5);
  std::vector<double> differences;
  for (int i = 0; i < 200; ++i) differences.push_back(draws()[4].one(rng));
  const Interval interval = confidence_sequence(differences, 0.05);
  const auto wealth = [&](double sign, double bar) {
    WealthProcess process(bar);
    for (const double difference : differences) process.add(sign * difference);
    return process.wealth();
  };
  EXPECT_GT(interval.low, 0.1);
  EXPECT_LT(interval.high, 0.3);
  EXPECT_GE(wealth(1.0, interval.low - 1e-6), 40.0);
  EXPECT_LT(wealth(1.0, interval.low + 1e-6), 40.0);
  EXPECT_GE(wealth(-1.0, -interval.high - 1e-6), 40.0);
  EXPECT_LT(wealth(-1.0, -interval.high + 1e-6), 40.0);
  for (double& difference : differences) difference = -difference;
  const Interval mirrored = confidence_sequence(differences, 0.05);
  EXPECT_NEAR(mirrored.low, -interval.high, 1e-8);
  EXPECT_NEAR(mirrored.high, -interval.low, 1e-8);
}

TEST(ConfidenceSequence, ContainsTheMeanAllTheTimeInMostSeries) {
  const int series = test::fewer(1600);
  for (const Draw& draw : draws()) {
    int missed = 0;
    for (int i = 0; i < series; ++i) {
      Rng rng(seed_for(7, "intervals", static_cast<std::uint64_t>(i)));
      std::vector<double> differences;
      bool out = false;
      for (int j = 0; j < 120 && !out; ++j) {
        differences.push_back(draw.one(rng));
        if (j % 10 != 9) continue;
        const Interval interval = confidence_sequence(differences, 0.1);
        out = draw.mean < interval.low || draw.mean > interval.high;
      }
      missed += out ? 1 : 0;
    }
    EXPECT_LE(missed, 0.1 * series + 4.0 * std::sqrt(0.1 * 0.9 * series)) << draw.mean;
  }
}

}  // namespace
}  // namespace labmouse
