#include "labmouse/lab/studies/parameter_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/studies/decimals.hpp"
#include "labmouse/lab/text/commas.hpp"

namespace labmouse {
namespace {

/// The number of decimals for four significant digits: 3 for 2.345, 0 for 2345 and above. At most 9, because
/// parse_plain_number() limits the length of a text.
int decimals_of(double value) {
  int decimals = 3;
  const double size = std::abs(value);
  for (double limit = 10.0; size >= limit && decimals > 0; limit *= 10.0) --decimals;
  for (double limit = 1.0; size < limit && decimals < 9; limit /= 10.0) ++decimals;
  return decimals;
}

const Parameter* find_number(const BuiltinMouse& mouse, std::string_view name) {
  const auto found = std::find_if(mouse.parameters.begin(), mouse.parameters.end(),
                                  [&](const Parameter& parameter) { return parameter.name == name; });
  return found == mouse.parameters.end() ? nullptr : &*found;
}

/// Why a parameter that is no number cannot be searched.
std::string no_number(const BuiltinMouse& mouse, const Parameter& parameter) {
  std::vector<std::string_view> numbers;
  for (const Parameter& other : mouse.parameters)
    if (is_number(other)) numbers.push_back(other.name);
  return fmt::format("parameter '{}' of mouse '{}' is a {}; only numbers can be tuned{}", parameter.name, mouse.name,
                     name_of(parameter.type),
                     numbers.empty() ? ", and it has none" : fmt::format(": {}", fmt::join(numbers, ", ")));
}

/// Reads one end of a range; returns what is wrong with it, or nothing.
std::string read_end(std::string_view spec, const Parameter& parameter, std::string_view text, double& end) {
  const Setting setting = {std::string(parameter.name), std::string(text)};
  if (const SpecResult variant = read_variant(spec, {&setting, 1}); !variant.error.empty()) return variant.error;
  end = parse_plain_number(text).value_or(0.0);
  return "";
}

/// Reads LOW:HIGH into the range; returns what is wrong, or nothing.
std::string read_ends(std::string_view spec, std::string_view text, ParameterRange& range) {
  const auto colon = text.find(':');
  const auto low = text.substr(0, colon), high = colon == std::string_view::npos ? "" : text.substr(colon + 1);
  if (!parse_plain_number(low) || !parse_plain_number(high) || !has_few_decimals(low) || !has_few_decimals(high))
    return fmt::format("'{}' is not a range; write LOW:HIGH with at most {} decimals, such as 0.2:0.8", text,
                       most_decimals);
  if (auto error = read_end(spec, range.parameter, low, range.low); !error.empty()) return error;
  if (auto error = read_end(spec, range.parameter, high, range.high); !error.empty()) return error;
  if (range.low >= range.high) return fmt::format("the upper end of the range '{}' must be above its lower end", text);
  return "";
}

/// Reads one NAME[=LOW:HIGH]; returns what is wrong, or nothing.
std::string read_one(std::string_view spec, const BuiltinMouse& mouse, std::string_view text,
                     std::vector<ParameterRange>& ranges) {
  const auto equals = text.find('=');
  const auto name = text.substr(0, equals);
  if (name.empty()) return fmt::format("'{}' is not of the form NAME or NAME=LOW:HIGH, separated by commas", text);
  const Parameter* parameter = find_number(mouse, name);
  if (parameter == nullptr) {
    const Setting unknown = {std::string(name), ""};
    return read_variant(spec, {&unknown, 1}).error;
  }
  if (!is_number(*parameter)) return no_number(mouse, *parameter);
  for (const ParameterRange& range : ranges)
    if (range.parameter.name == name) return fmt::format("parameter '{}' is named twice", name);
  ranges.push_back({*parameter, parameter->low, parameter->high});
  return equals == std::string_view::npos ? "" : read_ends(spec, text.substr(equals + 1), ranges.back());
}

}  // namespace

bool is_number(const Parameter& parameter) {
  return parameter.type == ParameterType::whole || parameter.type == ParameterType::real;
}

std::string written_value(const ParameterRange& range, double value) {
  value = std::clamp(value, range.low, range.high);
  const bool whole = range.parameter.type == ParameterType::whole;
  // Rounding may move a value beyond an end of the range. The ends have few decimals, so more decimals keep it inside.
  for (int decimals = whole ? 0 : decimals_of(value);; ++decimals) {
    std::string text = canonical_value(range.parameter, fmt::format("{:.{}f}", value, decimals));
    const double number = parse_plain_number(text).value_or(0.0);
    if ((number >= range.low && number <= range.high) || decimals > 9) return text;
  }
}

std::string value_at(const ParameterRange& range, double share) {
  const double width = range.high - range.low;
  if (range.parameter.type != ParameterType::whole) return written_value(range, range.low + share * width);
  return written_value(range, range.low + std::floor(share * (width + 1.0)));
}

double share_of(const ParameterRange& range, double value) {
  const double above = std::clamp(value, range.low, range.high) - range.low, width = range.high - range.low;
  // The middle of that number's share, so that a small change of the share does not change the number.
  return range.parameter.type == ParameterType::whole ? (above + 0.5) / (width + 1.0) : above / width;
}

RangesResult read_ranges(std::string_view spec, std::string_view text) {
  const SpecResult base = read_variant(spec, {});
  if (!base.error.empty()) return {{}, base.error};
  const BuiltinMouse& mouse = *entry_of(base.contestants.front());
  RangesResult result;
  for (const std::string& part : between_commas(text))
    if (auto error = read_one(spec, mouse, part, result.ranges); !error.empty()) return {{}, error};
  if (result.ranges.size() > most_ranges)
    return {{},
            fmt::format("{} parameters are named; at most {} can be tuned at once", result.ranges.size(), most_ranges)};
  return result;
}

}  // namespace labmouse
