// Parsing of numbers, with the same bits on every platform and independent of the locale.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>

namespace labmouse {

/// What is wrong with the text of a number.
enum class NumberProblem : std::uint8_t {
  none,
  no_number,
  too_large,  ///< for its type
  too_small,  ///< not 0, but smaller than the smallest normal double
};

/// Parses the whole text, such as `-12`, `0.25` or `2.5e-3`, and rounds to the nearest double. Rejects hexadecimal
/// digits, infinities, a leading plus, blanks and the locale's decimal sign. `number` changes only on success.
NumberProblem parse_number(std::string_view text, double& number);

/// The same, returned: nullopt on an error, and 0 for -0.
std::optional<double> parse_number(std::string_view text);

/// The same; nullopt also outside of `low` to `high` (both included).
std::optional<double> parse_number(std::string_view text, double low, double high);

/// Takes a whole number off the front of the text; a minus is accepted where the type is signed. Changes neither
/// argument on an error.
template <class Whole>
NumberProblem take_whole(std::string_view& text, Whole& number, int base = 10) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
  if (error == std::errc::result_out_of_range) return NumberProblem::too_large;
  if (error != std::errc()) return NumberProblem::no_number;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return NumberProblem::none;
}

/// The same, returned; nullopt on an error.
template <class Whole>
std::optional<Whole> take_whole(std::string_view& text, int base = 10) {
  Whole number = 0;
  return take_whole(text, number, base) == NumberProblem::none ? std::optional(number) : std::nullopt;
}

/// The same for the whole text; nullopt where anything follows the number.
template <class Whole>
std::optional<Whole> parse_whole(std::string_view text, int base = 10) {
  const auto number = take_whole<Whole>(text, base);
  return text.empty() ? number : std::nullopt;
}

}  // namespace labmouse
