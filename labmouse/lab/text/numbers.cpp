#include "labmouse/lab/text/numbers.hpp"

#include <fmt/format.h>

#include <cmath>

#include "labmouse/strategies/decimal_number.hpp"

namespace labmouse {
namespace {

/// A number as the program itself writes it; one that is too small to be written back is 0.
double read_back(std::string_view text, double otherwise) {
  double number = otherwise;
  return read_decimal(text, number) == NumberProblem::too_small ? std::copysign(0.0, otherwise) : number;
}

}  // namespace

std::optional<double> number_in(std::string_view text) {
  double number = 0.0;
  if (read_decimal(text, number) != NumberProblem::none) return std::nullopt;
  return number + 0.0;  // of -0, too, 0
}

std::optional<double> number_in(std::string_view text, double low, double high) {
  const std::optional<double> number = number_in(text);
  return number && *number >= low && *number <= high ? number : std::nullopt;
}

std::string_view why_no_number(std::string_view text) {
  double number = 0.0;
  switch (read_decimal(text, number)) {
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

double rounded(double value, int digits) { return read_back(fmt::format("{:.{}g}", value, digits), value); }

double decimal(float value) { return read_back(fmt::format("{}", value), static_cast<double>(value)); }

}  // namespace labmouse
