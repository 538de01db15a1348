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

double rounded(double value, int digits) { return read_back(fmt::format("{:.{}g}", value, digits), value); }

double decimal(float value) { return read_back(fmt::format("{}", value), static_cast<double>(value)); }

}  // namespace labmouse
