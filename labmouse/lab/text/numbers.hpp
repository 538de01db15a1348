// Numbers that cannot be read, and numbers rounded for writing.
#pragma once

#include <string_view>

namespace labmouse {

/// What is wrong with a text that is no number, as the end of a sentence: "is not a number"; empty where it is one.
std::string_view why_no_number(std::string_view text);

/// Rounded to so many significant digits. What is not finite stays as it is.
double rounded(double value, int digits);

/// The shortest decimal number that gives this 32-bit one: 265.2, where a mere conversion would give 265.2000122.
double decimal(float value);

}  // namespace labmouse
