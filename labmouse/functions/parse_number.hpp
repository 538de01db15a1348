// Numbers in texts, read with the same bits everywhere and whatever the locale: all modules read them so.
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
  too_small,  ///< it is not 0, but no double of full precision is as small
};

/// Reads `-12`, `0.25` or `2.5e-3`, all of the text or nothing, and rounds it to the nearest double. Hexadecimal
/// digits, infinities, signs in front other than a minus, blanks and the locale's decimal sign are no numbers.
/// `number` changes only where nothing is wrong.
NumberProblem parse_number(std::string_view text, double& number);

/// The same as a value, 0 for -0; nothing where something is wrong.
std::optional<double> parse_number(std::string_view text);

/// The same from `low` to `high`, both included.
std::optional<double> parse_number(std::string_view text, double low, double high);

/// Takes a whole number in digits off the front of the text, with a minus before them where its type has a sign.
/// Neither changes where something is wrong.
template <class Whole>
NumberProblem take_whole(std::string_view& text, Whole& number, int base = 10) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
  if (error == std::errc::result_out_of_range) return NumberProblem::too_large;
  if (error != std::errc()) return NumberProblem::no_number;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return NumberProblem::none;
}

/// The same as a value; nothing where something is wrong.
template <class Whole>
std::optional<Whole> take_whole(std::string_view& text, int base = 10) {
  Whole number = 0;
  return take_whole(text, number, base) == NumberProblem::none ? std::optional(number) : std::nullopt;
}

/// The same of all of the text.
template <class Whole>
std::optional<Whole> parse_whole(std::string_view text, int base = 10) {
  const auto number = take_whole<Whole>(text, base);
  return text.empty() ? number : std::nullopt;
}

}  // namespace labmouse
