#include "labmouse/strategies/parameter.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

#include "labmouse/functions/parse_number.hpp"

namespace labmouse {
namespace {

constexpr std::array<std::string_view, 2> yes = {"yes", "true"};
constexpr std::array<std::string_view, 2> no = {"no", "false"};

template <std::size_t N>
bool is_one_of(std::string_view word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// A number without leading and trailing zeros: `3`, `0.25`.
std::string plain(std::string_view number) {
  const bool negative = number.front() == '-';
  if (negative) number.remove_prefix(1);
  const auto point = number.find('.');
  std::string whole(number.substr(0, point));
  std::string fraction(point == std::string_view::npos ? "" : number.substr(point + 1));
  whole.erase(0, std::min(whole.find_first_not_of('0'), whole.size()));
  fraction.erase(fraction.find_last_not_of('0') + 1);
  if (whole.empty()) whole = "0";
  if (!fraction.empty()) whole += "." + fraction;
  return negative && whole != "0" ? "-" + whole : whole;
}

/// With at most six decimals, independent of the locale.
std::string plain(double number) {
  constexpr long long one = 1'000'000;
  const long long millionths = std::llround(std::abs(number) * static_cast<double>(one));
  std::string fraction = std::to_string(millionths % one + one);
  fraction.front() = '.';
  return plain((number < 0 ? "-" : "") + std::to_string(millionths / one) + fraction);
}

std::string check_number(const Parameter& parameter, std::string_view value) {
  const std::optional<double> number = parse_plain_number(value);
  if (!number) return "is not a number";
  if (parameter.type == ParameterType::whole && *number != std::floor(*number)) return "is not a whole number";
  if (*number < parameter.low || *number > parameter.high)
    return "is outside the range " + plain(parameter.low) + " to " + plain(parameter.high) + "; the nearest value is " +
           plain(*number < parameter.low ? parameter.low : parameter.high);
  return "";
}

std::string check_choice(const Parameter& parameter, std::string_view value) {
  const auto choices = choices_of(parameter);
  if (std::find(choices.begin(), choices.end(), value) != choices.end()) return "";
  const auto near = nearest_name(value, choices);
  if (!near.empty()) return "is unknown; did you mean '" + std::string(near) + "'?";
  if (choices.size() <= 12) return "is not one of " + std::string(parameter.choices);
  return "is not one of its " + std::to_string(choices.size()) + " choices, such as " + std::string(choices.front());
}

/// Edits (insert, delete, replace a letter) that lead from one word to another (Levenshtein 1966).
std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string_view name_of(ParameterType type) {
  switch (type) {
    case ParameterType::whole:
      return "whole number";
    case ParameterType::real:
      return "number";
    case ParameterType::flag:
      return "yes/no";
    case ParameterType::choice:
      return "choice";
    case ParameterType::list:
      return "list";
    case ParameterType::prior:
      return "prior";
  }
  return "unknown";
}

std::vector<std::string_view> choices_of(const Parameter& parameter) { return split(parameter.choices, '/'); }

Settings::Settings(std::span<const Parameter> parameters) {
  for (const Parameter& parameter : parameters)
    settings_.push_back({std::string(parameter.name), std::string(parameter.default_value)});
}

void Settings::set(std::string_view name, std::string_view value) {
  const auto setting =
      std::find_if(settings_.begin(), settings_.end(), [&](const Setting& s) { return s.name == name; });
  assert(setting != settings_.end());
  setting->value = value;
}

std::string_view Settings::choice(std::string_view name) const {
  const auto setting =
      std::find_if(settings_.begin(), settings_.end(), [&](const Setting& s) { return s.name == name; });
  assert(setting != settings_.end());
  return setting->value;
}

double Settings::real(std::string_view name) const {
  const std::optional<double> number = parse_plain_number(choice(name));
  assert(number);
  return number.value_or(0.0);
}

int Settings::whole(std::string_view name) const { return static_cast<int>(real(name)); }

bool Settings::flag(std::string_view name) const { return is_one_of(choice(name), yes); }

std::vector<double> Settings::list(std::string_view name) const {
  std::vector<double> numbers;
  for (const auto part : split(choice(name), '/')) numbers.push_back(parse_plain_number(part).value_or(0.0));
  return numbers;
}

std::string check_value(const Parameter& parameter, std::string_view value) {
  switch (parameter.type) {
    case ParameterType::whole:
    case ParameterType::real:
      return check_number(parameter, value);
    case ParameterType::flag:
      return is_one_of(value, yes) || is_one_of(value, no) ? "" : "must be yes or no";
    case ParameterType::choice:
      return check_choice(parameter, value);
    case ParameterType::list: {
      const auto parts = split(value, '/');
      const auto length = split(parameter.default_value, '/').size();
      if (parts.size() != length) return "must have " + std::to_string(length) + " elements separated by '/'";
      for (const auto part : parts)
        if (const auto reason = check_number(parameter, part); !reason.empty()) return "has an element that " + reason;
      return "";
    }
    case ParameterType::prior:
      return value.empty() ? "must be " + std::string(parameter.choices) + " or a file" : "";
  }
  return "";
}

std::string canonical_value(const Parameter& parameter, std::string_view value) {
  if (parameter.type == ParameterType::choice || parameter.type == ParameterType::prior) return std::string(value);
  if (parameter.type == ParameterType::flag) return is_one_of(value, yes) ? "yes" : "no";
  std::string numbers;
  for (const auto part : split(value, '/')) numbers += (numbers.empty() ? "" : "/") + plain(part);
  return numbers;
}

std::string_view nearest_name(std::string_view word, std::span<const std::string_view> candidates) {
  std::string_view nearest;
  std::size_t fewest = std::max<std::size_t>(2, word.size() / 2);  // more edits than this is another word
  for (const auto candidate : candidates)
    if (const std::size_t edits = edits_between(word, candidate);
        edits < fewest || (edits == fewest && nearest.empty())) {
      fewest = edits;
      nearest = candidate;
    }
  if (!nearest.empty() || word.size() < 3) return nearest;
  // A part of a name also matches.
  for (const auto candidate : candidates)
    if (candidate.find(word) != std::string_view::npos) return candidate;
  return nearest;
}

std::optional<double> parse_plain_number(std::string_view text) {
  return text.find_first_of("eE") == std::string_view::npos ? parse_number(text) : std::nullopt;
}

}  // namespace labmouse
