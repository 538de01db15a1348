#include "labmouse/lab/numbers/statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "labmouse/lab/numbers/maze_interval.hpp"
#include "labmouse/lab/numbers/sign_flips.hpp"
#include "labmouse/lab/numbers/student.hpp"
#include "labmouse/lab/numbers/verdict.hpp"
#include "labmouse/lab/numbers/wilson.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using Values = std::vector<double>;

TEST(Mean, IsTheSumOverTheCount) {
  EXPECT_DOUBLE_EQ(mean(Values{1.0, 2.0, 6.0}), 3.0);
  EXPECT_DOUBLE_EQ(mean(Values{}), 0.0);
}

TEST(MeanInterval, OfFewerThanTwoMazesIsTheMean) {
  EXPECT_EQ(mean_interval(Values{4.5}, 1), (Interval{4.5, 4.5}));
  EXPECT_EQ(mean_interval(Values{}, 1), Interval());
}

TEST(MeanInterval, OfEqualValuesIsTheirs) {
  EXPECT_EQ(mean_interval(Values(50, 7.0), 1), (Interval{7.0, 7.0}));
  const Interval odd = mean_interval(Values(50, 0.1), 1);  // 0.1 is rounded in each sum
  EXPECT_NEAR(odd.high - odd.low, 0.0, 1e-12);
}

TEST(MeanInterval, IsTheSameForTheSameSeed) {
  Values values;
  for (int i = 0; i < 20; ++i) values.push_back(i * i * i);
  EXPECT_EQ(mean_interval(values, 5), mean_interval(values, 5));
  EXPECT_NE(mean_interval(values, 5), mean_interval(values, 6));
}

TEST(MeanInterval, OfFewMazesIsTheTInterval) {
  const Interval interval = mean_interval(Values{1.0, 2.0, 3.0}, 1);
  EXPECT_NEAR(interval.low, 2.0 - 4.302652730 / std::sqrt(3.0), 1e-8);
  EXPECT_NEAR(interval.high, 2.0 + 4.302652730 / std::sqrt(3.0), 1e-8);
}

TEST(MeanInterval, IsAsWideAsTheoryForManyMazes) {
  // Values 0 and 1 in equal number: the mean of n has the deviation 0.5 / sqrt(n), and 95 % lie within 1.96 of them.
  Values values(400, 0.0);
  for (std::size_t i = 0; i < values.size(); i += 2) values[i] = 1.0;
  const Interval interval = mean_interval(values, 1);
  EXPECT_NEAR(interval.low, 0.5 - 1.96 * 0.025, 0.004);
  EXPECT_NEAR(interval.high, 0.5 + 1.96 * 0.025, 0.004);
}

TEST(MeanInterval, ReachesFartherWhereValuesMayBeFartherAway) {  // many small values and few large ones
  Values values(30, 1.0);
  values[3] = values[7] = 20.0;
  for (std::size_t i = 10; i < 30; ++i) values[i] += 0.1 * static_cast<double>(i);
  const Interval interval = mean_interval(values, 1);
  EXPECT_GT(interval.high - mean(values), 1.2 * (mean(values) - interval.low));
}

TEST(MazeInterval, HoldsTheMeanOverContestsAndNotThatOverMazes) {
  // The mean over contests is 10.4; that over the mazes is 25, outside of any interval of the former.
  std::vector<MazeSum> mazes(10, {200.0, 20.0});
  for (std::size_t i = 0; i < 5; ++i) mazes[i] = {40.0, 1.0};
  const double middle = mean_of(mazes);
  EXPECT_DOUBLE_EQ(middle, 1200.0 / 105.0);
  const Interval interval = interval_of(mazes, 1);
  EXPECT_LT(interval.low, middle);
  EXPECT_GT(interval.high, middle);
  EXPECT_LT(interval.high, 25.0);
  mazes.push_back({0.0, 0.0});  // a maze without values changes nothing
  EXPECT_EQ(interval_of(mazes, 1), interval);
}

TEST(ShareInterval, OfOneMazeIsThatOfItsContests) {
  EXPECT_EQ(share_interval(std::vector<MazeSum>{{15.0, 20.0}}), wilson_interval(0.75, 20));
}

TEST(ShareInterval, IsWiderWhereMazesDiffer) {  // half of the mazes always finished, half never: 20 facts, not 400
  std::vector<MazeSum> alike(20, {10.0, 20.0}), different(20, {20.0, 20.0});
  for (std::size_t i = 0; i < 10; ++i) different[i].sum = 0.0;
  const Interval narrow = share_interval(alike), wide = share_interval(different);
  EXPECT_NEAR(narrow.high - narrow.low, 0.104, 0.002);
  EXPECT_GT(wide.high - wide.low, 0.4);
}

TEST(ShareInterval, OfAllContestsIsNotCertain) {
  const Interval all = share_interval(std::vector<MazeSum>(43, {3.0, 3.0}));
  EXPECT_EQ(all.high, 1.0);
  EXPECT_LT(all.low, 0.98);
  EXPECT_EQ(share_interval({}), (Interval{0.0, 1.0}));
}

TEST(StudentQuantile, IsThatOfTables) {
  EXPECT_NEAR(student_quantile(1), 12.7062047362, 1e-9);
  EXPECT_NEAR(student_quantile(20), 2.0859634473, 1e-9);
  EXPECT_NEAR(student_quantile(21), 2.0796138447, 3e-7);
  EXPECT_NEAR(student_quantile(42), 2.0180817028, 1e-8);
  EXPECT_NEAR(student_quantile(299), 1.9679296691, 1e-9);
}

TEST(SignFlips, OfFewDifferencesCountAllWays) {
  EXPECT_DOUBLE_EQ(sign_flip_test(Values{1.0, 2.0, 3.0}, 1), 2.0 / 8.0);
  EXPECT_DOUBLE_EQ(sign_flip_test(Values{-1.0, 0.0, 2.0, 3.0, 0.0}, 1),
                   4.0 / 8.0);  // sums of 6 and of 4, and of -4 and -6
  EXPECT_DOUBLE_EQ(sign_flip_test(Values(8, -0.1), 1), 2.0 / 256.0);
  EXPECT_EQ(sign_flip_test(Values(9, 0.0), 1), 1.0);
  EXPECT_EQ(sign_flip_test(Values{}, 1), 1.0);
}

TEST(SignFlips, OfManyDifferencesAreDrawn) {
  Values values;
  for (int i = 0; i < 100; ++i) values.push_back(i % 3 - 0.9);  // mean 0.09, deviation 0.82: p = 0.27 by t
  EXPECT_NEAR(sign_flip_test(values, 1), 0.28, 0.03);
  EXPECT_EQ(sign_flip_test(values, 1), sign_flip_test(values, 1));
  EXPECT_DOUBLE_EQ(sign_flip_test(Values(100, 1.0), 1), 1.0 / 10000.0);
}

TEST(Holm, MultipliesByTheTestsThatAreLeft) {
  const std::vector<double> corrected = holm({0.04, 0.01, 0.03, 0.9});
  EXPECT_DOUBLE_EQ(corrected[0], 0.09);  // no less than that of 0.03
  EXPECT_DOUBLE_EQ(corrected[1], 0.04);
  EXPECT_DOUBLE_EQ(corrected[2], 0.09);
  EXPECT_DOUBLE_EQ(corrected[3], 0.9);
}

TEST(Verdicts, NeedEightMazesAndBothTestAndInterval) {
  const auto of = [](const Values& differences) {
    const PairedDifference found = paired_difference(differences, 1);
    return verdict_of(found, found.p);
  };
  Values better(8, -1.0);
  better[2] = -1.5;
  EXPECT_EQ(of(better), TestVerdict::better);
  for (double& value : better) value = -value;
  EXPECT_EQ(of(better), TestVerdict::worse);
  better.pop_back();
  EXPECT_EQ(of(better), TestVerdict::too_few);
  EXPECT_EQ(of(Values{-1, 1, -1, 1, -1, 1, -1, 1, 0.5}), TestVerdict::no_difference);
  PairedDifference found = paired_difference(Values(8, -1.0), 1);
  EXPECT_EQ(verdict_of(found, 0.06), TestVerdict::no_difference);
}

TEST(Verdicts, SayWhatToAddAndHowManyWereCorrected) {
  const PairedDifference few = paired_difference(Values(5, -1.0), 1), many = paired_difference(Values(9, -1.0), 1);
  EXPECT_THAT(verdict_notes({few}), test::Says("8 mazes", "Add 3", "--mazes"));
  EXPECT_EQ(verdict_notes({many}), "");
  EXPECT_THAT(verdict_notes({many, many}), test::Says("2 comparisons", "Holm"));
  EXPECT_EQ(verdict_notes({}), "");
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
  EXPECT_EQ(found.interval, mean_interval(differences, 7));
  EXPECT_EQ(found.below, 3);
  EXPECT_EQ(found.equal, 1);
  EXPECT_EQ(found.above, 2);
  EXPECT_EQ(found.sign_test, sign_test(3, 2));
  EXPECT_EQ(found.p, sign_flip_test(differences, 7));
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
  EXPECT_NEAR(found.interval.low, 1.5, 1e-9);
  EXPECT_NEAR(found.interval.high, 1.5, 1e-9);
}

TEST(PairedRatio, OverOnesHasTheIntervalOfTheMean) {
  Values values;
  for (int i = 0; i < 30; ++i) values.push_back(i % 7);
  EXPECT_EQ(paired_ratio(values, Values(values.size(), 1.0), 4).interval, mean_interval(values, 4));
}

}  // namespace
}  // namespace labmouse
