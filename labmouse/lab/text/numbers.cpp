#include "labmouse/lab/text/numbers.hpp"

#include <fmt/format.h>

#include <cmath>

#include "labmouse/functions/parse_number.hpp"

namespace labmouse {
namespace {

/// Reads a number that the program has formatted. One too small for a double becomes 0.
double read_back(std::string_view text, double otherwise) {
  double number = otherwise;
  return parse_number(text, number) == NumberProblem::too_small ? std::copysign(0.0, otherwise) : number;
}

}  // namespace

std::string_view why_no_number(std::string_view text) {
  double number = 0.0;
  switch (parse_number(text, number)) {
    case NumberProblem::no_number:
      return "is not a number";
    case NumberProblem::too_large:
      return "is too large a number";
    case NumberProblem::too_small:
      return "is too small a number; write 0";
    case NumberProblem::none:
      break;
  }
  return "";
}

std::string unit_hint(double value, double low, double high, std::string_view unit) {
  constexpr double degree = 3.141592653589793 / 180.0;
  if (unit.starts_with("rad") && value > high && value * degree <= high)
    return fmt::format("; if the value is in degrees{}, write {:.4g}", unit.substr(3), value * degree);
  const bool thousandths = unit.starts_with("mm") || unit == "ms";
  if (!thousandths || !(value * 1e3 >= low && value * 1e3 <= high)) return "";
  return fmt::format("; if the value is in {}, write {:g}", unit.substr(1), value * 1e3);
}

double rounded(double value, int digits) { return read_back(fmt::format("{:.{}g}", value, digits), value); }

double decimal(float value) { return read_back(fmt::format("{}", value), static_cast<double>(value)); }

}  // namespace labmouse
