#include "worlds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "command.hpp"
#include "labmouse/lab/text/commas.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse::cli {
namespace {

/// The value of --world with which mice race in several worlds.
constexpr std::string_view each_world = "each";

std::string why_no_world(const std::string& name) {
  if (find_world(name) != nullptr || name == each_world) return "";
  std::vector<std::string_view> names;
  for (const WorldEntry* entry : all_worlds()) names.push_back(entry->name);
  names.push_back(each_world);
  const auto near = nearest_name(name, names);
  return fmt::format("'{}' is none of {}{}", name, fmt::join(names, ", "),
                     near.empty() ? "" : fmt::format("; did you mean '{}'?", near));
}

/// Defaults by world: "20" where all worlds have the same, else "20 in steps, seconds; 3 in physical".
std::string by_world(const std::vector<std::pair<std::string, std::string_view>>& values) {
  std::vector<std::pair<std::string, std::vector<std::string_view>>> worlds_of;
  for (const auto& [value, world] : values) {
    auto found = std::find_if(worlds_of.begin(), worlds_of.end(),
                              [value = std::string_view(value)](const auto& one) { return one.first == value; });
    if (found == worlds_of.end()) found = worlds_of.insert(found, {value, {}});
    found->second.push_back(world);
  }
  if (worlds_of.size() == 1) return worlds_of.front().first;
  std::string text;
  for (const auto& [value, worlds] : worlds_of)
    text += fmt::format("{}{} in {}", text.empty() ? "" : "; ", value, fmt::join(worlds, ", "));
  return text;
}

/// The default of a setting in all worlds that have it.
std::string default_of(std::string_view name) {
  std::vector<std::pair<std::string, std::string_view>> values;
  for (const WorldEntry* entry : all_worlds())
    for (const WorldSetting& setting : entry->settings)
      if (setting.name == name)
        values.emplace_back(
            setting.half_size_default.empty()
                ? std::string(setting.default_value)
                : fmt::format("{}, in half-size mazes {}", setting.default_value, setting.half_size_default),
            entry->name);
  return by_world(values);
}

/// A setting's worlds, its meaning and, of a number, its range: "In physical: scale of all noise (0 to 100)". Whole
/// numbers get their range from in_range().
std::string meaning_of(const WorldSetting& setting) {
  std::vector<std::string_view> worlds;
  for (const WorldEntry* entry : all_worlds())
    for (const WorldSetting& each : entry->settings)
      if (each.name == setting.name) worlds.push_back(entry->name);
  std::string meaning(setting.meaning);
  meaning.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(meaning.front())));
  if (setting.kind == WorldSetting::Kind::number) meaning += fmt::format(" ({})", range_of(setting));
  return fmt::format("In {}: {}", fmt::join(worlds, ", "), meaning);
}

/// Each setting with the first world that has it. Worlds with the same setting share one option.
std::vector<std::pair<const WorldSetting*, const WorldEntry*>> all_settings() {
  std::vector<std::pair<const WorldSetting*, const WorldEntry*>> settings;
  for (const WorldEntry* entry : all_worlds())
    for (const WorldSetting& setting : entry->settings)
      if (std::none_of(settings.begin(), settings.end(),
                       [&](const auto& other) { return other.first->name == setting.name; }))
        settings.emplace_back(&setting, entry);
  return settings;
}

std::vector<Entry> taken(EntriesResult result) {
  if (!result.error.empty()) throw UsageError(result.error);
  for (const std::string& reason : result.left_out) tell(fmt::format("left out: {}\n", shown(reason)));
  tell_remarks(result.remarks);
  return std::move(result.entries);
}

}  // namespace

void add_setting(Command& command, const WorldSetting& setting, const std::string& meaning,
                 const std::string& default_value, WorldSettings& given) {
  const std::string name(setting.name), option = "--" + name;
  const auto take = [&given, name](const std::string& value) { given[name] = value; };
  switch (setting.kind) {
    case WorldSetting::Kind::flag:
      command.add_flag(
          option, [take] { take("true"); }, meaning);
      break;
    case WorldSetting::Kind::whole:
      command
          .add_integer(
              option, [take](std::uint64_t value) { take(fmt::format("{}", value)); }, meaning)
          ->type_name(std::string(setting.placeholder))
          ->check(in_range(static_cast<int>(setting.low), static_cast<int>(setting.high)))
          ->default_str(default_value);
      break;
    case WorldSetting::Kind::text:
    case WorldSetting::Kind::number:
      command.add_word(option, take, meaning)
          ->type_name(setting.choices.empty() ? std::string(setting.placeholder)
                                              : fmt::format("{}", fmt::join(setting.choices, "|")))
          ->default_str(default_value);
      break;
  }
}

void WorldChoice::add_to(Command& command) {
  std::string worlds = "World in which to run the contests; default: the one that suits the mice";
  for (const WorldEntry* entry : all_worlds()) worlds += fmt::format("\n{}: {}", entry->name, entry->summary);
  worlds += fmt::format("\n{}: the one that suits each mouse, with a race for each world", each_world);
  command.add_option("--world", world_, worlds)->type_name("WORLD")->check(Check(why_no_world));
  for (const auto& [setting, entry] : all_settings())
    add_setting(command, *setting, meaning_of(*setting), default_of(setting->name), given_);
}

std::vector<Entry> WorldChoice::enter_worlds(std::vector<Contestant> mice) const {
  std::vector<Entry> entries = taken(labmouse::enter(std::move(mice), world_ == each_world ? "" : world_, given_));
  if (const std::string unused = unused_setting(entries, given_); !unused.empty()) throw UsageError(unused);
  return entries;
}

std::vector<Entry> WorldChoice::enter(std::vector<Contestant> mice) const {
  std::vector<Entry> entries = enter_worlds(std::move(mice));
  const std::string advice = fmt::format("choose --world {} for a race in each", each_world);
  if (const std::string error = different_worlds(entries, advice); !error.empty() && world_ != each_world)
    throw UsageError(error);
  return entries;
}

std::size_t WorldChoice::values(const std::string& setting) const {
  const auto found = given_.find(setting);
  if (found == given_.end()) return 0;
  return between_commas(found->second).size();
}

Entry WorldChoice::enter_one(std::vector<Contestant> mice) const {
  std::vector<Entry> entries = taken(sole_entry(enter_worlds(std::move(mice))));
  return entries.empty() ? Entry{world(), {}, given_} : std::move(entries.front());
}

std::shared_ptr<const World> WorldChoice::world() const { return enter_worlds({}).front().world; }

std::string usual_runs_text() {
  std::vector<std::pair<std::string, std::string_view>> values;
  for (const WorldEntry* entry : all_worlds()) values.emplace_back(fmt::format("{}", entry->usual_runs), entry->name);
  return by_world(values);
}

}  // namespace labmouse::cli
