// Exponential and logarithm against those of the standard library.
#include "labmouse/functions/exponential.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace labmouse {
namespace {

TEST(Exponential, IsThatOfTheStandardLibraryButForTheLastBits) {
  for (double power = -700.0; power <= 700.0; power += 0.0137)
    ASSERT_NEAR(exp_of(power) / std::exp(power), 1.0, 1e-12) << power;
  EXPECT_EQ(exp_of(0.0), 1.0);
}

TEST(Logarithm, IsThatOfTheStandardLibraryButForTheLastBits) {
  for (double number = 1e-300; number < 1e300; number *= 1.0137)
    ASSERT_NEAR(log_of(number), std::log(number), 1e-13 * (1.0 + std::abs(std::log(number)))) << number;
  EXPECT_EQ(log_of(1.0), 0.0);
}

TEST(Logarithm, UndoesTheExponential) {
  for (double power = -50.0; power <= 50.0; power += 0.0171) ASSERT_NEAR(log_of(exp_of(power)), power, 1e-11) << power;
}

TEST(PowerOfTwo, IsExact) {
  for (int exponent = -1022; exponent <= 1023; ++exponent)
    ASSERT_EQ(power_of_two(exponent), std::ldexp(1.0, exponent)) << exponent;
}

TEST(Fading, IsTheExponentialOfTheNegativeNumberToA30000th) {
  for (double number = 0.0; number < 16.0; number += 0.00173)
    ASSERT_NEAR(fading(number) / std::exp(-number), 1.0, 1.0 / 30000.0) << number;
  EXPECT_EQ(fading(0.0), 1.0);
}

TEST(Fading, IsNothingFarAway) {
  EXPECT_EQ(fading(16.0), 0.0);
  EXPECT_EQ(fading(1e9), 0.0);
}

TEST(Fading, Falls) {
  for (double number = 0.0; number < 17.0; number += 0.00173) ASSERT_GE(fading(number), fading(number + 0.00173));
}

}  // namespace
}  // namespace labmouse
