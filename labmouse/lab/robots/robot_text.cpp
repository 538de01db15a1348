#include "labmouse/lab/robots/robot_text.hpp"

#include <fmt/format.h>

#include "labmouse/lab/robots/robot_keys.hpp"
#include "labmouse/lab/text/toml_text.hpp"

namespace labmouse {
namespace {

/// The section of a key (empty for none) and its name there.
std::pair<std::string, std::string> parts_of(std::string_view key) {
  const auto dot = key.find('.');
  if (dot == std::string_view::npos) return {"", std::string(key)};
  return {std::string(key.substr(0, dot)), std::string(key.substr(dot + 1))};
}

std::string text_of_value(const ReadJson& value) {
  return value.is_number() ? fmt::format("{}", value.get<double>())
                           : value.dump(-1, ' ', false, ReadJson::error_handler_t::replace);
}

std::string file_line(const std::string& assignment, std::string_view unit, const std::string& remark) {
  if (unit.empty() && remark.empty()) return assignment + "\n";
  return fmt::format("{:<29} # {}{}{}\n", assignment, unit, unit.empty() || remark.empty() ? "" : ", ", remark);
}

Json value_in(const toml::node& node) {
  if (const auto truth = node.value_exact<bool>()) return *truth;
  if (const auto whole = node.value_exact<std::int64_t>()) return *whole;
  if (const auto number = node.value_exact<double>()) return *number;
  if (const auto text = node.value_exact<std::string>()) return *text;
  return nullptr;
}

}  // namespace

std::string robot_text(const ReadJson& values, const std::function<std::string(std::string_view key)>& remark) {
  std::string text, section;
  for (const RobotKey& key : robot_keys()) {
    const auto value = values.find(std::string(key.name));
    if (value == values.end()) continue;
    const auto [group, name] = parts_of(key.name);
    if (group != section) text += fmt::format("\n[{}]\n", section = group);
    text += file_line(fmt::format("{} = {}", name, text_of_value(*value)), key.unit, remark(key.name));
  }
  return text;
}

Json robot_values(std::string_view text) {
  Json values = Json::object();
  const TomlText toml = parse_toml(text);
  if (!toml.problems.empty()) return values;
  for (const RobotKey& key : robot_keys()) {
    const auto [section, name] = parts_of(key.name);
    const toml::node* table = section.empty() ? &toml.table : toml.table.get(section);
    const toml::node* node = table != nullptr && table->is_table() ? table->as_table()->get(name) : nullptr;
    if (node == nullptr) continue;
    if (Json value = value_in(*node); !value.is_null()) values[std::string(key.name)] = std::move(value);
  }
  return values;
}

}  // namespace labmouse
