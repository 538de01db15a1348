#include "labmouse/lab/numbers/statistics.hpp"

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

TEST(Bootstrap, EqualValuesAreTheirInterval) {
  EXPECT_EQ(bootstrap_interval(Values(50, 7.0), 1), (Interval{7.0, 7.0}));
}

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

TEST(SignTest, OfFewThrowsIsWhatOneCounts) {
  EXPECT_DOUBLE_EQ(sign_test(0, 5), 2.0 / 32.0);
  EXPECT_DOUBLE_EQ(sign_test(1, 9), 22.0 / 1024.0);
  EXPECT_DOUBLE_EQ(sign_test(8, 2), 112.0 / 1024.0);
}

TEST(SignTest, OfManyThrowsIsTheExactSum) {  // sums of binomial coefficients in whole numbers
  EXPECT_NEAR(sign_test(25, 5) / 0.00032491423189640045, 1.0, 1e-12);
  EXPECT_NEAR(sign_test(132, 120) / 0.48842601828669646, 1.0, 1e-12);
  EXPECT_NEAR(sign_test(400, 600) / 2.7284641560660184e-10, 1.0, 1e-12);
  EXPECT_NEAR(sign_test(2450, 2550) / 0.1614852223973769, 1.0, 1e-12);
  EXPECT_NEAR(sign_test(0, 60) / 1.734723475976807e-18, 1.0, 1e-12);
}

TEST(SignTest, IsOneWhereNothingIsUneven) {
  EXPECT_EQ(sign_test(0, 0), 1.0);
  EXPECT_EQ(sign_test(3, 3), 1.0);
  EXPECT_EQ(sign_test(100, 101), 1.0);
  EXPECT_EQ(sign_test(0, 1), 1.0);
}

TEST(SignTest, KnowsNoOrderAndNoLimit) {
  EXPECT_EQ(sign_test(3, 11), sign_test(11, 3));
  EXPECT_EQ(sign_test(0, 1'000'000), 0.0);
  EXPECT_EQ(sign_test(1'000'000, 1'000'000), 1.0);
}

TEST(PairedDifference, CountsSigns) {
  const Values differences = {-1.0, 0.5, 0.0, -3.0, 2.0, -0.5};
  const PairedDifference found = paired_difference(differences, 7);
  EXPECT_EQ(found.count, 6);
  EXPECT_DOUBLE_EQ(found.mean, -2.0 / 6.0);
  EXPECT_EQ(found.interval, bootstrap_interval(differences, 7));
  EXPECT_EQ(found.below, 3);
  EXPECT_EQ(found.equal, 1);
  EXPECT_EQ(found.above, 2);
  EXPECT_EQ(found.sign_test, sign_test(3, 2));
}

TEST(PairedDifference, TakesScoresForEqualThatWereRoundedDifferently) {
  const double one = 10 + 7 / 30.0, same = 9 + 37 / 30.0;
  ASSERT_NE(one, same);
  EXPECT_EQ(paired_difference(Values{one - same, same - one}, 1).equal, 2);
  EXPECT_EQ(paired_difference(Values{1 / 600.0, -1 / 600.0}, 1).equal, 0);
}

TEST(PairedRatio, IsThatOfTheMeansAndNotTheMeanOfRatios) {
  EXPECT_DOUBLE_EQ(paired_ratio(Values{1.0, 30.0}, Values{2.0, 20.0}, 1).ratio, 31.0 / 22.0);
}

TEST(PairedRatio, OfValuesInProportionIsCertain) {  // however much the values differ
  Values values, others;
  for (int i = 1; i <= 50; ++i) {
    values.push_back(3.0 * i);
    others.push_back(2.0 * i);
  }
  const PairedRatio found = paired_ratio(values, others, 1);
  EXPECT_DOUBLE_EQ(found.ratio, 1.5);
  EXPECT_DOUBLE_EQ(found.interval.low, 1.5);
  EXPECT_DOUBLE_EQ(found.interval.high, 1.5);
}

TEST(PairedRatio, OverOnesHasTheIntervalOfTheMean) {
  Values values;
  for (int i = 0; i < 30; ++i) values.push_back(i % 7);
  EXPECT_EQ(paired_ratio(values, Values(values.size(), 1.0), 4).interval, bootstrap_interval(values, 4));
}

}  // namespace
}  // namespace labmouse
