// Small functions of numbers.
#pragma once

namespace labmouse {

constexpr double square(double number) { return number * number; }

/// The largest whole number that is not above, of one that an int can hold.
constexpr int whole_below(double number) {
  const auto whole = static_cast<int>(number);
  return whole - static_cast<int>(static_cast<double>(whole) > number);
}

}  // namespace labmouse
