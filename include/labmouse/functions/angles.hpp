// Sine and cosine with the same bits on every platform; those of the standard libraries differ in their last bits.
#pragma once

#include <array>
#include <cstddef>

namespace labmouse {

/// Half a turn, in rad.
inline constexpr double pi = 3.141592653589793;

/// Sine and cosine of one angle.
struct Direction {
  double sine = 0.0;
  double cosine = 1.0;
};

/// The direction of an angle. Uses basic arithmetic only.
/// @param angle in rad, of either sign, up to some thousands of turns.
/// @return with an error of about 1e-15.
constexpr Direction direction_of(double angle) {
  // Range reduction to an eighth of a turn: pi / 2 in two parts, the first with so few bits that its multiples are
  // exact.
  constexpr double quarter_high = 1.57079632673412561417;
  constexpr double quarter_low = 6.07710050650619224932e-11;
  const double quarters = angle / (pi / 2.0);
  const auto count = static_cast<long long>(quarters < 0.0 ? quarters - 0.5 : quarters + 0.5);
  const double rest = (angle - static_cast<double>(count) * quarter_high) - static_cast<double>(count) * quarter_low;

  // Taylor series, smallest term first.
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

/// Turns a direction to the left by a small angle. It keeps the length at 1, so that many turns may follow each other.
/// @param direction of length 1.
/// @param angle in rad, of either sign, up to 1/3.
/// @return with an error of 1e-9.
constexpr Direction turned_by(const Direction& direction, double angle) {
  const double square = angle * angle;
  const double sine = angle * (1.0 - square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0)));
  const double cosine = 1.0 - square / 2.0 * (1.0 - square / 12.0 * (1.0 - square / 30.0));
  const double s = direction.sine * cosine + direction.cosine * sine;
  const double c = direction.cosine * cosine - direction.sine * sine;
  const double length = (3.0 - s * s - c * c) / 2.0;  // approximates 1 / length near 1
  return {s * length, c * length};
}

namespace sine_table {

inline constexpr int steps = 1024;
inline constexpr auto values = [] {
  std::array<double, steps + 1> sines{};
  for (int i = 0; i <= steps; ++i) sines[static_cast<std::size_t>(i)] = direction_of(2.0 * pi * i / steps).sine;
  return sines;
}();

}  // namespace sine_table

/// The sine of an angle, from a table.
/// @param turns of any sign; 1 is a full circle.
/// @return with an error of 1e-5.
constexpr double sine_of_turns(double turns) {
  const auto whole = static_cast<long long>(turns);
  double part = turns - static_cast<double>(whole);
  if (part < 0.0) part += 1.0;
  const double place = part * sine_table::steps;
  const auto index = static_cast<std::size_t>(place) % sine_table::steps;
  const double rest = place - static_cast<double>(index);
  return sine_table::values[index] + rest * (sine_table::values[index + 1] - sine_table::values[index]);
}

}  // namespace labmouse
