// Numbers in texts of users: the one way in which the lab and the command line read and round them.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace labmouse {

/// A decimal number such as `-12`, `0.25` or `2.5e-3`, all of the text; nothing where it is none, or a double cannot
/// hold it. The locale does not matter.
std::optional<double> number_in(std::string_view text);

/// The same from `low` to `high`, both included.
std::optional<double> number_in(std::string_view text, double low, double high);

/// A whole number in digits, all of the text; nothing where it is none, or its type cannot hold it.
template <class Whole>
std::optional<Whole> whole_in(std::string_view text) {
  Whole number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// What is wrong with a text that is no number, as the end of a sentence: "is not a number"; empty where it is one.
std::string_view why_no_number(std::string_view text);

/// Rounded to so many significant digits. What is not finite stays as it is.
double rounded(double value, int digits);

/// The shortest decimal number that gives this 32-bit one: 265.2, where a mere conversion would give 265.2000122.
double decimal(float value);

}  // namespace labmouse
