// Sine and cosine of our own: those of the standard libraries differ in their last bits from platform to platform.
#pragma once

namespace labmouse {

inline constexpr double pi = 3.141592653589793;

/// Sine and cosine of one angle.
struct Direction {
  double sine = 0.0;
  double cosine = 1.0;
};

/// Of an angle in rad, up to some thousands of turns; plain sums of doubles, to about 1e-15.
constexpr Direction direction_of(double angle) {
  // To within an eighth of a turn, in two parts: the first has few bits, so its multiples are exact.
  constexpr double quarter_high = 1.57079632673412561417;
  constexpr double quarter_low = 6.07710050650619224932e-11;
  const double quarters = angle / (pi / 2.0);
  const auto count = static_cast<long long>(quarters < 0.0 ? quarters - 0.5 : quarters + 0.5);
  const double rest = (angle - static_cast<double>(count) * quarter_high) - static_cast<double>(count) * quarter_low;

  // Taylor's sums, smallest term first.
  const double square = rest * rest;
  double sine = 0.0;
  double cosine = 0.0;
  for (int n = 16; n > 0; n -= 2) {
    sine = (1.0 - sine) * square / (n * (n + 1));
    cosine = (1.0 - cosine) * square / (n * (n - 1));
  }
  sine = rest * (1.0 - sine);
  cosine = 1.0 - cosine;
  switch (count & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

}  // namespace labmouse
