// Explains invalid numbers, and rounds numbers for writing.
#pragma once

#include <string>
#include <string_view>

namespace labmouse {

/// The error of an invalid number, as the end of a sentence: "is not a number"; empty for a valid one.
std::string_view why_no_number(std::string_view text);

/// The end of a message about a value that is not from `low` to `high`, in `unit`, if it would be in metres, seconds or
/// degrees: "; if the value is in m/s, write 300". Otherwise empty.
std::string unit_hint(double value, double low, double high, std::string_view unit);

/// The value with that many significant digits; infinities and NaN stay.
double rounded(double value, int digits);

/// The shortest decimal number that rounds to this 32-bit float: 265.2, where a conversion gives 265.2000122.
double decimal(float value);

}  // namespace labmouse
