#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "labmouse/lab/studies/decimals.hpp"
#include "labmouse/lab/studies/sweep.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {
namespace {

// Ranges count in whole millionths, so that a value cannot become 0.30000000000000004.
constexpr long long one = 1'000'000;
constexpr double largest = 1e9;

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (;;) {
    const auto end = text.find(separator);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::optional<long long> millionths(std::string_view text) {
  const std::optional<double> number = parse_plain_number(text);
  if (!has_few_decimals(text) || !number || std::abs(*number) > largest) return std::nullopt;
  return std::llround(*number * static_cast<double>(one));
}

std::string decimal(long long count) {
  std::string text = fmt::format("{}{}.{:06}", count < 0 ? "-" : "", std::abs(count) / one, std::abs(count) % one);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

/// Reads LOW:HIGH:STEP into the values; returns what is wrong, or nothing.
std::string read_range(std::string_view text, std::vector<std::string>& values) {
  std::vector<long long> numbers;
  for (const std::string& part : split(text, ':'))
    if (const auto number = millionths(part)) numbers.push_back(*number);
  if (numbers.size() != 3 || std::count(text.begin(), text.end(), ':') != 2)
    return fmt::format("'{}' is not a range; write LOW:HIGH:STEP with at most {} decimals, such as 0:1:0.1", text,
                       most_decimals);
  const long long low = numbers[0], high = numbers[1], step = numbers[2];
  if (step <= 0) return fmt::format("the step of the range '{}' must be above 0", text);
  if (high < low) return fmt::format("the upper end of the range '{}' is below its lower end", text);
  const long long count = (high - low) / step + 1;
  if (count > most_values)
    return fmt::format("the range '{}' has {} values; the limit is {}", text, count, most_values);
  for (long long i = 0; i < count; ++i) values.push_back(decimal(low + i * step));
  return "";
}

std::string read_list(std::string_view text, std::vector<std::string>& values) {
  values = split(text, ',');
  if (std::find(values.begin(), values.end(), "") != values.end())
    return fmt::format("the list '{}' has an empty value", text);
  // No value of a parameter has this form, but some programs write ranges like this.
  const auto dash = text.find('-', 1);
  if (dash != std::string_view::npos && millionths(text.substr(0, dash)) && millionths(text.substr(dash + 1)))
    return fmt::format("'{}' is not a number; write a range as LOW:HIGH:STEP, with ':' in place of '-'", text);
  if (values.size() <= most_values) return "";
  return fmt::format("the list has {} values; the limit is {}", values.size(), most_values);
}

}  // namespace

SweptValues read_swept_values(std::string_view text) {
  SweptValues swept;
  const auto equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0) {
    swept.error = fmt::format("'{}' is not of the form NAME=LOW:HIGH:STEP or NAME=VALUE,VALUE,...", text);
    return swept;
  }
  swept.parameter = text.substr(0, equals);
  const auto values = text.substr(equals + 1);
  const bool range = values.find(':') != std::string_view::npos;
  swept.error = range ? read_range(values, swept.values) : read_list(values, swept.values);
  if (!swept.error.empty()) swept.values.clear();
  return swept;
}

}  // namespace labmouse
