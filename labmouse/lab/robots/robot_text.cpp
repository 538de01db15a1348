#include "labmouse/lab/robots/robot_text.hpp"

#include <fmt/format.h>

#include "labmouse/lab/robots/hardware_keys.hpp"
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

template <class Sensor>
std::string list_text(const ReadJson& values, std::string_view list, std::span<const SensorKey<Sensor>> keys) {
  std::string text;
  const auto found = values.find(std::string(list));
  if (found == values.end() || !found->is_array()) return text;
  for (const ReadJson& sensor : *found) {
    text += fmt::format("\n[[{}]]\n", list);
    for (const SensorKey<Sensor>& key : keys)
      if (const auto value = sensor.find(std::string(key.key.name)); value != sensor.end())
        text += file_line(fmt::format("{} = {}", key.key.name, text_of_value(*value)), key.key.unit, "");
  }
  return text;
}

/// The sensors of a list; null where there is none.
template <class Sensor>
Json list_values(const toml::table& file, std::string_view list, std::span<const SensorKey<Sensor>> keys) {
  const toml::array* entries = file[list].as_array();
  if (entries == nullptr) return nullptr;
  Json values = Json::array();
  for (const toml::node& entry : *entries) {
    Json sensor = Json::object();
    const toml::table* table = entry.as_table();
    for (const SensorKey<Sensor>& key : keys)
      if (const toml::node* node = table == nullptr ? nullptr : table->get(key.key.name))
        if (Json value = value_in(*node); !value.is_null()) sensor[std::string(key.key.name)] = std::move(value);
    values.push_back(std::move(sensor));
  }
  return values;
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
  return text + list_text(values, infrared_list, infrared_keys()) + list_text(values, ranger_list, ranger_keys());
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
  const auto add_list = [&](std::string_view list, Json sensors) {
    if (!sensors.is_null()) values[std::string(list)] = std::move(sensors);
  };
  add_list(infrared_list, list_values(toml.table, infrared_list, infrared_keys()));
  add_list(ranger_list, list_values(toml.table, ranger_list, ranger_keys()));
  return values;
}

}  // namespace labmouse
