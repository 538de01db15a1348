#include "labmouse/lab/text/toml_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {

void TomlFields::add(const toml::source_position& place, std::string reason) {
  problems_.push_back(problem_at(place, std::move(reason)));
}

void TomlFields::refuse_unknown(const toml::table& table, std::span<const std::string_view> known) {
  for (const auto& [key, value] : table)
    if (std::find(known.begin(), known.end(), today_key(key.str())) == known.end())
      add(key, unknown_key(std::string(key.str()), known));
}

std::string TomlFields::text(const toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return "";
  std::string value = node->value<std::string>().value_or("");
  if (value.empty() || shown(value) != value)
    add(node->source().begin, fmt::format("'{}' must be a text in quotation marks, printable and not empty", key));
  return value;
}

std::vector<std::string> TomlFields::texts(const toml::table& table, std::string_view key, std::string_view example) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return {};
  const toml::array* array = node->as_array();
  std::vector<std::string> values;
  const auto is_text = [](const toml::node& each) {
    const auto value = each.value<std::string>();
    return each.is_string() && value->find('\0') == std::string::npos;
  };
  if (array == nullptr || !std::all_of(array->begin(), array->end(), is_text)) {
    add(node->source().begin, fmt::format("'{}' must be a list of texts, such as {}", key, example));
    return {};
  }
  for (const toml::node& each : *array) values.push_back(*each.value<std::string>());
  return values;
}

bool TomlFields::flag(const toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return false;
  if (!node->is_boolean()) add(node->source().begin, fmt::format("'{}' must be true or false", key));
  return node->is_boolean() && *node->value<bool>();
}

std::optional<int> TomlFields::whole(const toml::table& table, std::string_view key, int low, int high) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return std::nullopt;
  const auto value = node->value<std::int64_t>();
  if (node->is_integer() && *value >= low && *value <= high) return static_cast<int>(*value);
  add(node->source().begin, fmt::format("'{}' must be a whole number from {} to {}", key, low, high));
  return std::nullopt;
}

std::optional<double> TomlFields::number(const toml::table& table, std::string_view key, double low, double high,
                                         std::string_view unit) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return std::nullopt;
  const double value = node->value<double>().value_or(std::nan(""));
  if (node->is_number() && value >= low && value <= high) return value;
  add(node->source().begin, fmt::format("'{}' must be a number{} from {:g} to {:g}", key, unit, low, high));
  return std::nullopt;
}

}  // namespace labmouse
