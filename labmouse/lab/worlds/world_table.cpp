#include "labmouse/lab/worlds/world_table.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "labmouse/lab/text/printable.hpp"
#include "labmouse/lab/worlds/worlds.hpp"

namespace labmouse {
namespace {

std::string read_setting(const WorldSetting& setting, const toml::node& node, TomlFields& fields) {
  std::string text = node.value<std::string>().value_or(""), problem;
  if (const auto number = node.value<double>(); node.is_number()) text = fmt::format("{}", *number);
  if (const auto flag = node.value<bool>(); node.is_boolean()) text = *flag ? "true" : "false";
  if (setting.kind == WorldSetting::Kind::flag && !node.is_boolean())
    problem = "must be true or false";
  else if (text.empty() || shown(text) != text)
    problem = "must be a number or a printable text";
  else
    chosen_value(setting, text, problem);
  if (!problem.empty()) fields.add(node.source().begin, fmt::format("'{}': {}", key_of(setting), problem));
  return text;
}

}  // namespace

NamedWorld read_world(const toml::table& table, TomlFields& fields) {
  NamedWorld named = {all_worlds().front(), {}};
  if (const std::string name = fields.text(table, "world"); !name.empty()) {
    if (const WorldEntry* world = find_world(name))
      named.entry = world;
    else
      fields.add(table.get("world")->source().begin,
                 fmt::format("there is no world '{}'; {}", name, "`labmouse race --help` lists them"));
  }
  const toml::node* node = table.get("settings");
  if (node == nullptr) return named;
  const toml::table* settings = node->as_table();
  if (settings == nullptr) {
    fields.add(node->source().begin, "'settings' must be a table of the settings of the world");
    return named;
  }
  std::vector<std::string> keys;
  for (const WorldSetting& setting : named.entry->settings) keys.push_back(key_of(setting));
  fields.refuse_unknown(*settings, std::vector<std::string_view>(keys.begin(), keys.end()));
  for (const WorldSetting& setting : named.entry->settings)
    if (const toml::node* value = settings->get(key_of(setting)))
      named.settings[std::string(setting.name)] = read_setting(setting, *value, fields);
  return named;
}

WorldResult make_world(const NamedWorld& named, const std::string& folder) {
  WorldSettings settings = named.settings;
  for (const WorldSetting& setting : named.entry->settings) {
    const auto chosen = settings.find(setting.name);
    if (chosen != settings.end() && can_be_file(setting, beside(folder, chosen->second)))
      chosen->second = beside(folder, chosen->second);
  }
  return named.entry->make(settings);
}

bool can_be_file(const WorldSetting& setting, const std::string& path) {
  std::error_code unknown;
  return setting.kind == WorldSetting::Kind::text && setting.choices.empty() &&
         std::filesystem::is_regular_file(path, unknown);
}

std::string beside(const std::string& folder, const std::string& name) {
  const std::string path = (std::filesystem::path(folder) / name).string();
  std::error_code unknown;
  const bool is_pattern = name.find_first_of("*?[") != std::string::npos;
  return is_pattern || std::filesystem::exists(path, unknown) ? path : name;
}

}  // namespace labmouse
