#include "labmouse/lab/races/world_setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/text/numbers.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

using Kind = WorldSetting::Kind;

std::string wrong_number(const WorldSetting& setting, const std::string& text) {
  if (setting.least_chosen > setting.low) {
    const std::optional<double> number = parse_number(text);
    return fmt::format("'{}' is neither {} nor a number from {} to {} {}{}", shown(text), setting.low,
                       setting.least_chosen, setting.high, setting.unit,
                       number ? unit_hint(*number, setting.least_chosen, setting.high, setting.unit) : "");
  }
  std::string wrong = fmt::format("'{}' is not a {}number from {} to {}", shown(text),
                                  setting.kind == Kind::whole ? "whole " : "", setting.low, setting.high);
  for (const NamedNumber& one : setting.named)
    wrong += fmt::format("{}{}", &one == setting.named.data() ? ", or one of " : ", ", one.name);
  return wrong;
}

/// The text, with a former name replaced by today's. Sets `error`, such as "none of first and last", if it is no
/// choice.
std::string choice_of(const WorldSetting& setting, std::string text, std::string& error) {
  const std::span all = setting.choices;
  if (all.empty()) return text;
  text = today_value(text);
  if (std::find(all.begin(), all.end(), text) == all.end())
    error = fmt::format("none of {} and {}", fmt::join(all.first(all.size() - 1), ", "), all.back());
  return text;
}

}  // namespace

Value chosen_value(const WorldSetting& setting, const std::string& text, std::string& error) {
  if (setting.kind == Kind::flag) return text == "true";
  if (setting.kind == Kind::text) {
    std::string today = choice_of(setting, text, error);
    if (!error.empty()) error = fmt::format("'{}' is {}", shown(text), error);
    return today;
  }
  const auto named = std::find_if(setting.named.begin(), setting.named.end(),
                                  [&](const NamedNumber& one) { return one.name == text; });
  if (named != setting.named.end()) return named->number;
  const std::optional<double> number = parse_number(text, setting.low, setting.high);
  const bool whole = setting.kind == Kind::whole;
  if (!number || (*number > setting.low && *number < setting.least_chosen) || (whole && *number != std::floor(*number)))
    return error = wrong_number(setting, text), Value();
  return whole ? Value(static_cast<std::int64_t>(*number)) : Value(*number);
}

Value read_value(const WorldSetting& setting, JsonFields& fields) {
  const std::string key = key_of(setting);
  if (setting.kind == Kind::flag) return fields.flag(key.c_str());
  if (setting.kind == Kind::number) return fields.number(key.c_str(), setting.low, setting.high);
  if (setting.kind == Kind::whole)
    return fields.long_whole(key.c_str(), static_cast<std::int64_t>(setting.low),
                             static_cast<std::int64_t>(setting.high));
  std::string error, text = choice_of(setting, fields.text(key.c_str()), error);
  if (!error.empty()) fields.fail(fmt::format("has a '{}' that is {}", key, error));
  return text;
}

std::string range_of(const WorldSetting& setting) {
  if (setting.least_chosen > setting.low)
    return fmt::format("{}, or {} to {} {}", setting.low, setting.least_chosen, setting.high, setting.unit);
  return fmt::format("{} to {}", setting.low, setting.high);
}

std::string key_of(const WorldSetting& setting) {
  std::string key(setting.name);
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

std::string text_of(std::span<const WorldSetting> all, const WorldSettings& chosen, std::string_view name) {
  if (const auto found = chosen.find(name); found != chosen.end()) return found->second;
  const auto setting =
      std::find_if(all.begin(), all.end(), [&](const WorldSetting& each) { return each.name == name; });
  return std::string(setting->default_value);
}

}  // namespace labmouse
