// The simulation that chose the intervals and the test of verdicts: how often an interval contains the true mean, and
// how often two equal mice are told apart. docs/explanation/statistics-and-bounds.md has the table that it prints where
// it is thorough.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "labmouse/chance/rng.hpp"
#include "labmouse/functions/normal.hpp"
#include "labmouse/lab/numbers/maze_interval.hpp"
#include "labmouse/lab/numbers/statistics.hpp"
#include "labmouse/lab/numbers/student.hpp"
#include "labmouse/lab/numbers/verdict.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using Values = std::vector<double>;

/// What one maze adds to a mean, drawn anew; and the mean of all mazes that there could be.
struct Scores {
  std::string name;
  std::function<double(Rng&)> draw;
  double mean = 0.0;
};

double normal(Rng& rng) { return NormalNumber::of(rng.bits()); }
/// Between 0 and 1.
double uniform(Rng& rng) { return (static_cast<double>(rng.bits() >> 12U) + 0.5) / 4503599627370496.0; }
double skewed(Rng& rng, double deviation) { return 25.0 * std::exp(deviation * normal(rng)); }

/// The mean of so many runs in a maze, in each of which the mouse fails by that chance, which counts `limit`.
double with_failures(Rng& rng, int runs, double chance, double limit) {
  const double usual = skewed(rng, 0.4);
  double sum = 0.0;
  for (int run = 0; run < runs; ++run) sum += uniform(rng) < chance ? limit : usual * (1.0 + 0.1 * normal(rng));
  return sum / runs;
}

double difference_of_runs(Rng& rng, int runs) {
  double sum = 0.0;
  for (int run = 0; run < runs; ++run) sum += skewed(rng, 0.5) - skewed(rng, 0.5);
  return sum / runs;
}

std::vector<Scores> all_scores() {
  const double usual = 25.0 * std::exp(0.08);
  return {
      {"skewed (log-normal, 0.5)", [](Rng& rng) { return skewed(rng, 0.5); }, 25.0 * std::exp(0.125)},
      {"very skewed (exponential)", [](Rng& rng) { return -std::log(uniform(rng)); }, 1.0},
      {"ties: 3 values",
       [](Rng& rng) {
         const double u = uniform(rng);
         return u < 0.4 ? 20.0 : u < 0.7 ? 22.0 : 25.0;
       },
       22.1},
      {"differences, half of them 0", [](Rng& rng) { return uniform(rng) < 0.5 ? 0.0 : normal(rng); }, 0.0},
      {"30 % fail, 1 run, limit 100", [](Rng& rng) { return with_failures(rng, 1, 0.3, 100.0); }, 0.7 * usual + 30.0},
      {"0 to 40 % fail, 20 runs, limit 300", [](Rng& rng) { return with_failures(rng, 20, 0.4 * uniform(rng), 300.0); },
       0.8 * usual + 60.0},
      {"a mouse less itself, 5 runs", [](Rng& rng) { return difference_of_runs(rng, 5); }, 0.0}};
}

bool contains(const Interval& interval, double value) { return interval.low <= value && value <= interval.high; }

double deviation_of(const Values& values) {
  const double middle = mean(values);
  double squares = 0.0;
  for (const double value : values) squares += (value - middle) * (value - middle);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

Interval student_interval(const Values& values) {
  const double reach = student_quantile(static_cast<int>(values.size()) - 1) * deviation_of(values) /
                       std::sqrt(static_cast<double>(values.size()));
  return {mean(values) - reach, mean(values) + reach};
}

/// The percentile bootstrap, which labmouse used before.
Interval percentile_interval(const Values& values, Rng& rng) {
  Values means(999);
  for (double& each : means) {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
      sum += values[static_cast<std::size_t>(rng.below(static_cast<int>(values.size())))];
    each = sum / static_cast<double>(values.size());
  }
  std::sort(means.begin(), means.end());
  return {means[24], means[974]};
}

/// In percent: how often each method contains the mean, and how often equal mice are told apart.
struct Coverage {
  double percentile = 0.0, student = 0.0, ours = 0.0, differences_of = 0.0;
};

Coverage coverage_of(const Scores& scores, int mazes, int trials, bool all_methods) {
  Rng rng(seed_for(1, scores.name, static_cast<std::uint64_t>(mazes)));
  Coverage coverage;
  const double part = 100.0 / trials;
  for (int trial = 0; trial < trials; ++trial) {
    Values values(static_cast<std::size_t>(mazes));
    for (double& value : values) value = scores.draw(rng);
    coverage.ours += contains(mean_interval(values, rng.bits()), scores.mean) ? part : 0.0;
    if (!all_methods) continue;
    coverage.percentile += contains(percentile_interval(values, rng), scores.mean) ? part : 0.0;
    coverage.student += contains(student_interval(values), scores.mean) ? part : 0.0;
    if (scores.mean != 0.0) continue;
    const PairedDifference found = paired_difference(values, rng.bits());
    const TestVerdict verdict = verdict_of(found, found.p);
    coverage.differences_of += verdict == TestVerdict::better || verdict == TestVerdict::worse ? part : 0.0;
  }
  return coverage;
}

/// Of so few mazes, one sample of six has no failure among its runs, and no interval can know of one.
bool sees_all(const Scores& scores, int mazes) {
  return scores.name.find(", 1 run") == std::string::npos || mazes >= 20;
}

TEST(Coverage, OfIntervalsIsNinetyFivePercent) {
  LABMOUSE_SKIP_SANITIZED();
  if (!test::thorough) {
    for (const Scores& scores : all_scores()) {
      const Coverage found = coverage_of(scores, 20, 150, false);
      EXPECT_GE(found.ours, 90.0) << scores.name;
      EXPECT_LE(found.ours, 99.5) << scores.name;
    }
    return;
  }
  std::fputs("scores | mazes | percentile bootstrap | t | labmouse | told apart\n", stdout);
  for (const Scores& scores : all_scores())
    for (const int mazes : {5, 8, 10, 20, 43, 100, 300}) {
      const Coverage found = coverage_of(scores, mazes, mazes > 43 ? 200 : 1000, true);
      const std::string told =
          scores.mean == 0.0 && mazes >= fewest_for_verdict ? fmt::format("{:.1f}", found.differences_of) : "";
      std::fputs(fmt::format("{} | {} | {:.1f} | {:.1f} | {:.1f} | {}\n", scores.name, mazes, found.percentile,
                             found.student, found.ours, told)
                     .c_str(),
                 stdout);
      // 93 to 97, and two standard errors of the trials. Few tied values leave no interval that is less than too wide.
      const double error = mazes > 43 ? 4.0 : 1.9;
      if (sees_all(scores, mazes)) {
        EXPECT_GE(found.ours, 93.0 - error) << scores.name << ", " << mazes;
      }
      if (mazes >= 20) {
        EXPECT_LE(found.ours, 97.0 + error) << scores.name << ", " << mazes;
      }
      EXPECT_LE(found.differences_of, 5.0 + error) << scores.name << ", " << mazes;
    }
}

/// So many contests in each maze, in which a mouse finishes by a chance of the maze's own between `low` and `high`.
double share_coverage(double low, double high, int mazes, int runs, int trials) {
  Rng rng(7);
  double covered = 0.0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<MazeSum> sums(static_cast<std::size_t>(mazes));
    for (MazeSum& maze : sums) {
      const double chance = low + (high - low) * uniform(rng);
      maze.count = runs;
      for (int run = 0; run < runs; ++run) maze.sum += uniform(rng) < chance ? 1.0 : 0.0;
    }
    covered += contains(share_interval(sums), (low + high) / 2.0) ? 100.0 / trials : 0.0;
  }
  return covered;
}

TEST(Coverage, OfSharesIsThatOfMazesAndNotOfContests) {
  const int trials = test::thorough ? 2000 : 400;
  for (const int mazes : {8, 20, 43})
    for (const int runs : {1, 3, 20})
      for (const auto& [low, high] : {std::pair(0.0, 1.0), std::pair(0.5, 1.0), std::pair(0.8, 1.0)}) {
        const double covered = share_coverage(low, high, mazes, runs, trials);
        EXPECT_GE(covered, 91.0) << mazes << " mazes, " << runs << " runs, from " << low;
      }
}

TEST(Coverage, EqualMiceAreSeldomToldApart) {
  const Scores scores = all_scores().back();
  int differences_of = 0;
  const int trials = test::thorough ? 1000 : 100;
  Rng rng(3);
  for (int trial = 0; trial < trials; ++trial) {
    Values values(8);
    for (double& value : values) value = scores.draw(rng);
    const PairedDifference found = paired_difference(values, rng.bits());
    const TestVerdict verdict = verdict_of(found, found.p);
    differences_of += verdict == TestVerdict::better || verdict == TestVerdict::worse ? 1 : 0;
  }
  EXPECT_LE(differences_of, 0.1 * trials);  // of 1,000, 45
}

}  // namespace
}  // namespace labmouse
