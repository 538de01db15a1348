#include "labmouse/lab/numbers/least_squares.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "labmouse/chance/dice.hpp"
#include "labmouse/functions/normal.hpp"

namespace labmouse {
namespace {

using Free = std::array<std::optional<double>, 3>;

/// y = 2 + 3 x - 0.001 x², whose unknowns differ by far.
LeastSquares parabola(double from, double to) {
  LeastSquares problem(3);
  for (double x = from; x <= to; ++x) problem.add(std::array{1.0, x, x * x}, 2.0 + 3.0 * x - 0.001 * x * x);
  return problem;
}

TEST(LeastSquares, FindsWhatTheRowsAddUpTo) {
  const auto found = parabola(0.0, 40.0).solution(Free{});
  ASSERT_TRUE(found);
  EXPECT_NEAR((*found)[0], 2.0, 1e-9);
  EXPECT_NEAR((*found)[1], 3.0, 1e-9);
  EXPECT_NEAR((*found)[2], -0.001, 1e-11);
  EXPECT_NEAR(parabola(0.0, 40.0).squares(*found), 0.0, 1e-6);
}

TEST(LeastSquares, KeepsWhatIsFixed) {
  LeastSquares problem(2);
  problem.add(std::array{1.0, 1.0}, 3.0);
  problem.add(std::array{1.0, 2.0}, 5.0);
  const auto found = problem.solution(std::array<std::optional<double>, 2>{1.0, std::nullopt});
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ((*found)[0], 1.0);
  EXPECT_DOUBLE_EQ((*found)[1], 2.0);
}

TEST(LeastSquares, SaysWhereRowsDoNotTellUnknownsApart) {
  LeastSquares problem(2);
  for (const double x : {1.0, 2.0, 3.0}) problem.add(std::array{x, 2.0 * x}, x);
  EXPECT_FALSE(problem.solution(std::array<std::optional<double>, 2>{}));
  EXPECT_FALSE(LeastSquares(1).solution(std::array<std::optional<double>, 1>{}));
}

TEST(LeastSquares, PartsCanBeAddedAndTakenAway) {
  LeastSquares all = parabola(0.0, 40.0);
  LeastSquares odd(3);
  odd.add(std::array{1.0, 5.0, 25.0}, 1000.0, 4.0);
  all += odd;
  EXPECT_GT(std::abs((*all.solution(Free{}))[0] - 2.0), 1.0);
  all -= odd;
  EXPECT_NEAR((*all.solution(Free{}))[0], 2.0, 1e-6);
}

TEST(Jackknife, OfAMeanIsItsStandardError) {
  const std::vector<double> values = {1.0, 2.0, 4.0, 9.0};
  std::vector<double> without;
  for (const double value : values) without.push_back((16.0 - value) / 3.0);
  EXPECT_NEAR(jackknife_error(without), std::sqrt(38.0 / 3.0 / 4.0), 1e-12);
}

/// Noise that is like its neighbours: the mean of 20 blocks is less sure than that of as many single values.
TEST(Jackknife, OverBlocksCountsWhatNeighboursShare) {
  Dice dice(1);
  std::vector<double> noise;
  double last = 0.0, sum = 0.0;
  constexpr std::size_t count = 4000, block = 200;
  for (std::size_t i = 0; i < count; ++i) {
    last = 0.95 * last + NormalNumber::of(dice.bits());
    noise.push_back(last);
    sum += last;
  }
  const auto error_by = [&](std::size_t size) {
    std::vector<double> without;
    for (std::size_t begin = 0; begin < count; begin += size) {
      double rest = sum;
      for (std::size_t i = begin; i < begin + size; ++i) rest -= noise[i];
      without.push_back(rest / static_cast<double>(count - size));
    }
    return jackknife_error(without);
  };
  const double true_error = 1.0 / 0.05 / std::sqrt(static_cast<double>(count));
  EXPECT_NEAR(error_by(block) / true_error, 1.0, 0.4);
  EXPECT_LT(error_by(1), 0.3 * true_error);
}

}  // namespace
}  // namespace labmouse
