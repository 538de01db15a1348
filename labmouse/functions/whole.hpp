// Small numeric functions.
#pragma once

namespace labmouse {

constexpr double square(double number) { return number * number; }

/// Floor of a number that fits into an int.
constexpr int whole_below(double number) {
  const auto whole = static_cast<int>(number);
  return whole - static_cast<int>(static_cast<double>(whole) > number);
}

}  // namespace labmouse
