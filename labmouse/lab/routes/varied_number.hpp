// A number of a robot file and its range of variation.
#pragma once

#include <string>
#include <string_view>

namespace labmouse {

/// The key of the number, and its range in the key's unit with both ends included.
struct VariedNumber {
  std::string key;
  double from = 0.0, to = 0.0;
};

/// The unit of its key.
std::string unit_of(const VariedNumber& number);

/// Parses `KEY=FROM:TO`: a number, or an error.
struct VariedNumberResult {
  VariedNumber number;
  std::string error;
};
VariedNumberResult read_varied_number(std::string_view text);

}  // namespace labmouse
