// Exponential and logarithm with the same bits on every platform; those of the standard libraries differ in their last
// bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "labmouse/functions/bits.hpp"

namespace labmouse {

inline constexpr double ln_2 = 0.69314718055994530942;

/// 2 to the power of a whole number from -1022 to 1023.
constexpr double power_of_two(int exponent) {
  return bits_as<double>(static_cast<std::uint64_t>(1023 + exponent) << 52U);
}

/// e^power for a power from -700 to 700; relative error about 1e-13. Uses basic arithmetic only.
constexpr double exp_of(double power) {
  const double twos = power / ln_2;
  const auto whole = static_cast<int>(twos < 0.0 ? twos - 0.5 : twos + 0.5);
  const double rest = power - whole * ln_2;
  // Taylor series up to ln 2 / 2, in Horner form.
  constexpr double inverse[] = {1.0 / 10, 1.0 / 9, 1.0 / 8, 1.0 / 7, 1.0 / 6, 1.0 / 5, 1.0 / 4, 1.0 / 3, 1.0 / 2};
  double sum = 1.0 + rest * (1.0 / 11);
  for (const double part : inverse) sum = 1.0 + rest * part * sum;
  return (1.0 + rest * sum) * power_of_two(whole);
}

/// Natural logarithm of a normal number above 0; error about 1e-13. Uses basic arithmetic only.
constexpr double log_of(double number) {
  constexpr std::uint64_t fraction = (std::uint64_t{1} << 52U) - 1;
  const auto bits = bits_as<std::uint64_t>(number);
  auto exponent = static_cast<int>(bits >> 52U) - 1023;
  double mantissa = bits_as<double>((bits & fraction) | std::uint64_t{1023} << 52U);
  if (mantissa > 1.4142135623730951) {
    mantissa /= 2.0;
    ++exponent;
  }
  // ln m = 2 artanh z, and z is at most 0.172.
  const double z = (mantissa - 1.0) / (mantissa + 1.0), square = z * z;
  constexpr double inverse[] = {1.0 / 13, 1.0 / 11, 1.0 / 9, 1.0 / 7, 1.0 / 5, 1.0 / 3, 1.0};
  double sum = 1.0 / 15;
  for (const double part : inverse) sum = part + square * sum;
  return exponent * ln_2 + 2.0 * z * sum;
}

namespace fading_table {

inline constexpr int steps = 64, most = 16;
inline constexpr auto values = [] {
  std::array<double, steps * most + 1> powers{};
  for (std::size_t i = 0; i < powers.size(); ++i) powers[i] = exp_of(-static_cast<double>(i) / steps);
  return powers;
}();

}  // namespace fading_table

/// e^-number for a number from 0 on, from a table; relative error 1/30,000. It is 0 from 16 on.
constexpr double fading(double number) {
  if (number >= fading_table::most) return 0.0;
  const double place = number * fading_table::steps;
  const auto index = static_cast<std::size_t>(place);
  const double rest = place - static_cast<double>(index);
  return fading_table::values[index] + rest * (fading_table::values[index + 1] - fading_table::values[index]);
}

}  // namespace labmouse
