// The normal distribution: shares against the error function of the standard library, and numbers against the
// distribution that they should have.
#include "labmouse/functions/normal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace labmouse {
namespace {

double true_share(double number) { return std::erfc(-number / std::sqrt(2.0)) / 2.0; }

/// Numbers from bits that are spread evenly over all there are: their mean is an integral.
std::vector<double> even_numbers() {
  std::vector<double> numbers;
  constexpr std::uint64_t count = 1U << 18U;
  for (std::uint64_t i = 0; i < count; ++i) numbers.push_back(NormalNumber::of((2 * i + 1) << (63U - 18U)));
  return numbers;
}

TEST(NormalShare, IsTheIntegralOfTheDistribution) {
  for (double number = -6.0; number <= 6.0; number += 0.0037)
    ASSERT_NEAR(NormalShare::below(number), true_share(number), 2e-5) << number;
}

TEST(NormalShare, GrowsFromNothingToAll) {
  EXPECT_EQ(NormalShare::below(-4.6), 0.0);
  EXPECT_EQ(NormalShare::below(4.6), 1.0);
  EXPECT_EQ(NormalShare::below(1e9), 1.0);
  EXPECT_EQ(NormalShare::below(-1e9), 0.0);
  for (double number = -5.0; number < 5.0; number += 0.01)
    ASSERT_LE(NormalShare::below(number), NormalShare::below(number + 0.01)) << number;
}

TEST(NormalNumber, HasMean0AndDeviation1) {
  double sum = 0.0, squares = 0.0;
  for (const double number : even_numbers()) {
    sum += number;
    squares += number * number;
  }
  const auto count = static_cast<double>(even_numbers().size());
  EXPECT_NEAR(sum / count, 0.0, 1e-9);
  EXPECT_NEAR(squares / count, 1.0, 1e-4);
}

TEST(NormalNumber, LiesBelowEachBoundAsOftenAsItShould) {
  std::vector<double> numbers = even_numbers();
  std::sort(numbers.begin(), numbers.end());
  for (double bound = -3.0; bound <= 3.0; bound += 0.05) {
    const auto below = std::lower_bound(numbers.begin(), numbers.end(), bound) - numbers.begin();
    ASSERT_NEAR(static_cast<double>(below) / static_cast<double>(numbers.size()), true_share(bound), 2e-4) << bound;
  }
}

TEST(NormalNumber, IsNeverFarOut) {
  for (const std::uint64_t bits : {std::uint64_t{0}, ~std::uint64_t{0}, ~std::uint64_t{0} >> 1U})
    EXPECT_LT(std::abs(NormalNumber::of(bits)), 3.8);
}

TEST(NormalNumber, IsAsOftenAboveAsBelow) {
  constexpr std::uint64_t sign = std::uint64_t{1} << 63U;
  for (std::uint64_t bits = 0; bits < sign - (1ULL << 50U); bits += 1234567890123457U)
    ASSERT_EQ(NormalNumber::of(bits), -NormalNumber::of(bits | sign)) << bits;
}

}  // namespace
}  // namespace labmouse
