// The normal distribution with the same bits on every platform, from tables computed at compile time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "labmouse/functions/bits.hpp"
#include "labmouse/functions/exponential.hpp"

namespace labmouse {

/// The cumulative distribution function of the standard normal distribution, from a table; error about 1e-5. It is 0
/// and 1 beyond 4.5 standard deviations.
class NormalShare {
 public:
  static constexpr double reach = 4.5;

  static constexpr double below(double number) {
    const double place = (number + reach) * steps;
    if (place <= 0.0) return 0.0;
    const auto index = static_cast<std::size_t>(place);
    if (index + 1 >= table.size()) return 1.0;
    const double rest = place - static_cast<double>(index);
    return table[index] + rest * (table[index + 1] - table[index]);
  }

 private:
  static constexpr int steps = 64;  ///< per standard deviation

  static constexpr auto table = [] {
    constexpr auto count = static_cast<std::size_t>(2 * reach * steps) + 1;
    constexpr double width = 1.0 / steps, per_root_of_two_pi = 0.39894228040143267794;
    const auto density = [](double x) { return per_root_of_two_pi * exp_of(-x * x / 2.0); };
    std::array<double, count> shares{};
    for (std::size_t i = 1; i < count; ++i) {
      const double from = -reach + static_cast<double>(i - 1) * width;
      // Simpson's rule. The sum is normalised below, because the tails beyond `reach` are missing.
      shares[i] =
          shares[i - 1] + width / 6.0 * (density(from) + 4.0 * density(from + width / 2.0) + density(from + width));
    }
    const double all = shares.back();
    for (double& share : shares) share /= all;
    return shares;
  }();
};

/// Standard normal random numbers from random bits.
class NormalNumber {
 public:
  /// Of the 64 bits, one is the sign, ten choose a quantile, and 32 interpolate to the next one. No result exceeds 3.8;
  /// the standard deviation is 1.
  static constexpr double of(std::uint64_t bits) {
    const auto index = static_cast<std::size_t>(bits >> 53U & (cells - 1));
    const double rest = static_cast<double>(static_cast<std::uint32_t>(bits >> 16U)) * (1.0 / 4294967296.0);
    const double size = table[index] + rest * (table[index + 1] - table[index]);
    return bits_as<double>(bits_as<std::uint64_t>(size) | (bits & std::uint64_t{1} << 63U));
  }

 private:
  static constexpr std::size_t cells = 1024;

  /// Quantiles of |x|: entry i is the quantile of i / cells, so that all cells between two entries are equally likely.
  /// Runge-Kutta over dx = sqrt(pi / 2) w dp, where w is exp(x² / 2) and dw = x w dx. The last entry makes the standard
  /// deviation 1.
  static constexpr auto table = [] {
    constexpr double root = 1.25331413731550025121, part = 1.0 / cells / 4;
    struct Point {
      double x, w;
    };
    const auto slope = [](const Point& at) { return Point{root * at.w, root * at.x * at.w * at.w}; };
    const auto ahead = [](const Point& at, const Point& by, double p) {
      return Point{at.x + p * by.x, at.w + p * by.w};
    };
    std::array<double, cells + 1> sizes{};
    Point at{0.0, 1.0};
    double squares = 0.0;  // three times the sum of the cells' mean squares so far
    for (std::size_t i = 1; i < cells; ++i) {
      for (int substep = 0; substep < 4; ++substep) {
        const Point a = slope(at), b = slope(ahead(at, a, part / 2)), c = slope(ahead(at, b, part / 2)),
                    d = slope(ahead(at, c, part));
        at = {at.x + part / 6 * (a.x + 2 * b.x + 2 * c.x + d.x), at.w + part / 6 * (a.w + 2 * b.w + 2 * c.w + d.w)};
      }
      sizes[i] = at.x;
      squares += sizes[i - 1] * sizes[i - 1] + sizes[i - 1] * sizes[i] + sizes[i] * sizes[i];
    }
    // Solves x² + x y + y² = left for the last entry y by bisection: the mean square over all cells must be 1, so that
    // `squares` comes to 3 for each cell.
    const double left = 3.0 * cells - squares, x = sizes[cells - 1];
    double low = x, high = 2.0 * x;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2.0;
      (x * x + x * middle + middle * middle > left ? high : low) = middle;
    }
    sizes[cells] = low;
    return sizes;
  }();
};

}  // namespace labmouse
