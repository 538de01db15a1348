// Our own parser: on some of our platforms the standard library has none that is exact and ignores the locale.
#include "labmouse/functions/parse_number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace labmouse {
namespace {

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

/// The number 0.DIGITS * 10^point. It has room for all digits that the midpoint of two neighbouring doubles may have.
class Decimal {
 public:
  /// Appends a digit. A digit beyond the capacity, if it is not 0, only sets the lowest bit of the last one: then the
  /// number is not taken for a midpoint.
  void add(int digit) {
    if (count_ < most)
      digits_[count_++] = static_cast<std::uint8_t>(digit);
    else if (digit != 0)
      digits_.back() |= 1U;
  }
  void drop_zeros_behind() {
    while (count_ > 0 && digits_[count_ - 1] == 0) --count_;
  }

  bool is_zero() const { return count_ == 0; }
  std::size_t count() const { return count_; }

  /// Divides by 2^times; times is at most 59.
  void halve(unsigned times) {
    Decimal result;
    result.point = point;
    std::uint64_t rest = 0;
    for (std::size_t i = 0; i < count_ || rest != 0; ++i) {
      rest = rest * 10 + (i < count_ ? digits_[i] : 0U);
      const std::uint64_t digit = rest >> times;
      rest -= digit << times;
      if (digit == 0 && result.count_ == 0)
        --result.point;
      else
        result.add(static_cast<int>(digit));
      if (i >= count_ && result.count_ == most && rest != 0) {
        result.digits_.back() |= 1U;
        break;
      }
    }
    result.drop_zeros_behind();
    *this = result;
  }

  /// Multiplies by 2^times; times is at most 59.
  void twice(unsigned times) {
    constexpr std::size_t longest = 20;  // room for the 18 digits that 2^59 adds at most
    std::array<std::uint8_t, most + longest> product = {};
    std::size_t first = product.size();
    std::uint64_t carry = 0;
    for (std::size_t i = count_; i > 0 || carry != 0;) {
      if (i > 0) carry += std::uint64_t{digits_[--i]} << times;
      product[--first] = static_cast<std::uint8_t>(carry % 10);
      carry /= 10;
    }
    point += static_cast<int>(product.size() - first) - static_cast<int>(count_);
    count_ = 0;
    for (; first < product.size(); ++first) add(product[first]);
    drop_zeros_behind();
  }

  bool is_below_a_half() const { return point < 0 || (point == 0 && digits_[0] < 5); }

  /// Rounds to the nearest whole number, ties to even.
  std::uint64_t rounded() const {
    std::uint64_t whole = 0;
    const auto end = static_cast<std::size_t>(std::max(point, 0));
    for (std::size_t i = 0; i < end; ++i) whole = whole * 10 + (i < count_ ? digits_[i] : 0U);
    if (point < 0 || end >= count_ || digits_[end] < 5) return whole;
    const bool middle = digits_[end] == 5 && end + 1 == count_;
    return middle ? whole + whole % 2 : whole + 1;
  }

  /// All digits as a whole number; exact for at most 15.
  double head() const {
    double number = 0.0;
    for (std::size_t i = 0; i < count_; ++i) number = number * 10.0 + digits_[i];
    return number;
  }

  int point = 0;

 private:
  static constexpr std::size_t most = 800;

  std::array<std::uint8_t, most> digits_ = {};
  std::size_t count_ = 0;
};

/// An exponent with 2^result <= 10^digits, at most 59.
unsigned doublings(int digits) { return static_cast<unsigned>(std::min(digits, 18) * 33 / 10); }

/// Converts through binary digits: exact, but slow.
NumberProblem convert(Decimal decimal, double& number) {
  constexpr int mantissa_bits = 53, most_exponent = 1023, least_exponent = -1022;
  int exponent = 0;
  while (decimal.point > 0) {
    const unsigned times = doublings(decimal.point);
    decimal.halve(times);
    exponent += static_cast<int>(times);
  }
  while (decimal.is_below_a_half()) {
    const unsigned times = std::max(1U, doublings(-decimal.point));
    decimal.twice(times);
    exponent -= static_cast<int>(times);
  }
  decimal.twice(mantissa_bits);
  std::uint64_t mantissa = decimal.rounded();
  if (mantissa >> mantissa_bits != 0) {
    mantissa >>= 1U;
    ++exponent;
  }
  if (exponent - 1 > most_exponent) return NumberProblem::too_large;
  if (exponent - 1 < least_exponent) return NumberProblem::too_small;
  number = std::ldexp(static_cast<double>(mantissa), exponent - mantissa_bits);
  return NumberProblem::none;
}

NumberProblem value_of(const Decimal& decimal, double& number) {
  constexpr std::size_t exact_digits = 15;
  constexpr std::array powers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  if (decimal.is_zero()) return number = 0.0, NumberProblem::none;
  if (decimal.point > 320) return NumberProblem::too_large;
  if (decimal.point < -320) return NumberProblem::too_small;
  // Digits and power are both exact in a double, so their product or quotient is rounded correctly.
  const int power = decimal.point - static_cast<int>(decimal.count());
  const auto size = static_cast<std::size_t>(std::abs(power));
  if (decimal.count() > exact_digits || size >= powers.size()) return convert(decimal, number);
  number = power < 0 ? decimal.head() / powers[size] : decimal.head() * powers[size];
  return NumberProblem::none;
}

/// Takes digits and their decimal point off the front of the text; false where there are none.
bool take_digits(std::string_view& text, Decimal& decimal) {
  constexpr int most_point = 1'000'000'000;
  bool any = false, fraction = false, leading = true;
  while (!text.empty() && (is_digit(text.front()) || (text.front() == '.' && !fraction))) {
    const char letter = text.front();
    text.remove_prefix(1);
    if (letter == '.') {
      fraction = true;
      continue;
    }
    any = true;
    leading = leading && letter == '0';
    if (leading && fraction && decimal.point > -most_point) --decimal.point;
    if (leading) continue;
    decimal.add(letter - '0');
    if (!fraction && decimal.point < most_point) ++decimal.point;
  }
  decimal.drop_zeros_behind();
  return any;
}

/// Reads an exponent such as `e-3` to the end of the text; cuts a huge one to one million.
bool take_power(std::string_view text, int& power) {
  constexpr int most_power = 1'000'000;
  if (text.empty()) return true;
  if (text.front() != 'e' && text.front() != 'E') return false;
  text.remove_prefix(1);
  const bool negative = !text.empty() && text.front() == '-';
  if (negative || (!text.empty() && text.front() == '+')) text.remove_prefix(1);
  if (text.empty() || !std::all_of(text.begin(), text.end(), is_digit)) return false;
  for (const char letter : text) power = std::min(power * 10 + (letter - '0'), most_power);
  if (negative) power = -power;
  return true;
}

}  // namespace

NumberProblem parse_number(std::string_view text, double& number) {
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  Decimal decimal;
  int power = 0;
  if (!take_digits(text, decimal) || !take_power(text, power)) return NumberProblem::no_number;
  decimal.point += power;
  double size = 0.0;
  if (const NumberProblem problem = value_of(decimal, size); problem != NumberProblem::none) return problem;
  number = negative ? -size : size;
  return NumberProblem::none;
}

std::optional<double> parse_number(std::string_view text) {
  double number = 0.0;
  if (parse_number(text, number) != NumberProblem::none) return std::nullopt;
  return number + 0.0;  // turns -0 into 0
}

std::optional<double> parse_number(std::string_view text, double low, double high) {
  const std::optional<double> number = parse_number(text);
  return number && *number >= low && *number <= high ? number : std::nullopt;
}

}  // namespace labmouse
