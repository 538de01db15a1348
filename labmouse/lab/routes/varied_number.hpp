// A number of a robot file and how far it is varied.
#pragma once

#include <string>
#include <string_view>

namespace labmouse {

/// By the name of its key, in the key's unit; both ends are included.
struct VariedNumber {
  std::string key;
  double from = 0.0, to = 0.0;
};

/// The unit of its key.
std::string unit_of(const VariedNumber& number);

/// The number that `KEY=FROM:TO` names, or why it names none: exactly one of the two counts.
struct VariedNumberResult {
  VariedNumber number;
  std::string error;
};
VariedNumberResult read_varied_number(std::string_view text);

}  // namespace labmouse
