#include "labmouse/lab/text/number_rows.hpp"

#include <algorithm>
#include <limits>

#include "labmouse/lab/text/packing.hpp"

namespace labmouse {
namespace {

constexpr char repeats = '~';
constexpr unsigned bits = 5, more = 1U << bits;
/// More bits than any difference of two numbers has.
constexpr unsigned most_bits = 40;

void add_number(std::int64_t number, std::string& text) {
  auto rest = number < 0 ? static_cast<std::uint64_t>(-number) << 1U | 1U : static_cast<std::uint64_t>(number) << 1U;
  do {
    const auto digit = static_cast<unsigned>(rest % more);
    rest >>= bits;
    text += base64_digits[digit + (rest > 0 ? more : 0U)];
  } while (rest > 0);
}

/// Removes a number from the front of the text; false where there is none.
bool take_number(std::string_view& text, std::int64_t& number) {
  std::uint64_t all = 0;
  for (unsigned shift = 0; !text.empty() && shift < most_bits; shift += bits) {
    const auto digit = base64_digits.find(text.front());
    if (digit == std::string_view::npos) return false;
    text.remove_prefix(1);
    all |= static_cast<std::uint64_t>(digit % more) << shift;
    if (digit >= more) continue;
    number = static_cast<std::int64_t>(all >> 1U);
    if (all % 2 == 1) number = -number;
    return true;
  }
  return false;
}

}  // namespace

std::string rows_text(std::span<const std::int32_t> numbers, std::size_t columns) {
  std::string text;
  std::vector<std::int32_t> last(columns);
  std::int64_t again = 0;
  const auto add_repeats = [&] {
    if (again > 0) add_number(again, text += repeats);
    again = 0;
  };
  for (; !numbers.empty(); numbers = numbers.subspan(columns)) {
    if (std::equal(last.begin(), last.end(), numbers.begin()) && !text.empty()) {
      ++again;
      continue;
    }
    add_repeats();
    for (std::size_t i = 0; i < columns; ++i) add_number(std::int64_t{numbers[i]} - last[i], text);
    std::copy_n(numbers.begin(), columns, last.begin());
  }
  add_repeats();
  return text;
}

bool read_rows(std::string_view text, std::size_t columns, std::size_t most, std::vector<std::int32_t>& numbers) {
  std::vector<std::int32_t> last(columns);
  for (bool any = false; !text.empty(); any = true) {
    std::int64_t rows = 1, number = 0;
    if (text.front() == repeats) {
      text.remove_prefix(1);
      if (!any || !take_number(text, rows) || rows < 1) return false;
    } else {
      for (std::int32_t& each : last) {
        if (!take_number(text, number)) return false;
        number += each;
        if (number < std::numeric_limits<std::int32_t>::min() || number > std::numeric_limits<std::int32_t>::max())
          return false;
        each = static_cast<std::int32_t>(number);
      }
    }
    if (static_cast<std::uint64_t>(rows) > (most - std::min(most, numbers.size())) / columns) return false;
    for (; rows > 0; --rows) numbers.insert(numbers.end(), last.begin(), last.end());
  }
  return true;
}

}  // namespace labmouse
