// Decimal numbers, read with the same bits everywhere.
#pragma once

#include <cstdint>
#include <string_view>

namespace labmouse {

/// What is wrong with the text of a number.
enum class NumberProblem : std::uint8_t {
  none,
  no_number,
  too_large,  ///< for a double
  too_small,  ///< it is not 0, but no double of full precision is as small
};

/// Reads `-12`, `0.25` or `2.5e-3`, all of the text or nothing, and rounds it to the nearest double. Hexadecimal
/// digits, infinities, signs in front other than a minus, blanks and the locale's decimal sign are no numbers.
/// `number` changes only where nothing is wrong.
NumberProblem read_decimal(std::string_view text, double& number);

}  // namespace labmouse
