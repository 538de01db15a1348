#include "labmouse/lab/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "labmouse/chance/dice.hpp"

namespace labmouse {
namespace {

using Values = std::vector<double>;

TEST(Mean, IsTheSumOverTheCount) {
  EXPECT_DOUBLE_EQ(mean(Values{1.0, 2.0, 6.0}), 3.0);
  EXPECT_DOUBLE_EQ(mean(Values{}), 0.0);
}

TEST(Bootstrap, OneValueIsItsInterval) { EXPECT_EQ(bootstrap_interval(Values{4.5}, 1), (Interval{4.5, 4.5})); }

TEST(Bootstrap, EqualValuesAreTheirInterval) { EXPECT_EQ(bootstrap_interval(Values(50, 7.0), 1), (Interval{7.0, 7.0})); }

TEST(Bootstrap, NoValueGivesZeros) { EXPECT_EQ(bootstrap_interval(Values{}, 1), Interval()); }

TEST(Bootstrap, IsTheSameForTheSameSeed) {
  Values values;
  for (int i = 0; i < 100; ++i) values.push_back(std::sqrt(i));
  EXPECT_EQ(bootstrap_interval(values, 5), bootstrap_interval(values, 5));
  EXPECT_NE(bootstrap_interval(values, 5), bootstrap_interval(values, 6));
}

TEST(Bootstrap, IsAsWideAsTheoryForManyThrows) {
  // Values 0 and 1 in equal number: the mean of n has the deviation 0.5 / sqrt(n), and 95 % lie within 1.96 of them.
  Values values(400, 0.0);
  for (std::size_t i = 0; i < values.size(); i += 2) values[i] = 1.0;
  const Interval interval = bootstrap_interval(values, 1);
  EXPECT_NEAR(interval.low, 0.5 - 1.96 * 0.025, 0.004);
  EXPECT_NEAR(interval.high, 0.5 + 1.96 * 0.025, 0.004);
}

TEST(Bootstrap, CoversTheTruthAboutNineteenTimesOfTwenty) {
  Dice dice(2);
  int covered = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Values values(40);
    for (double& value : values) value = dice.below(101);
    const Interval interval = bootstrap_interval(values, dice.bits());
    if (interval.low <= 50.0 && 50.0 <= interval.high) ++covered;
  }
  EXPECT_GE(covered, 270);
  EXPECT_LE(covered, 298);
}

}  // namespace
}  // namespace labmouse
