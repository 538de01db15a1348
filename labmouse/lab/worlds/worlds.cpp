#include "labmouse/lab/worlds/worlds.hpp"

#include <algorithm>

#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {
namespace {

/// The text of a setting; nothing where the value is no good one.
std::optional<std::string> text_of_setting(const WorldSetting& setting, const ReadJson& value) {
  switch (setting.kind) {
    case WorldSetting::Kind::flag:
      return value.is_boolean() ? std::optional(value.get<bool>() ? "true" : "false") : std::nullopt;
    case WorldSetting::Kind::whole:
      if (!value.is_number_integer() || value < setting.low || value > setting.high) return std::nullopt;
      return std::to_string(value.get<std::int64_t>());
    case WorldSetting::Kind::text:
      return value.is_string() ? std::optional(value.get<std::string>()) : std::nullopt;
  }
  return std::nullopt;
}

/// The kind of record that is meant, or that of the first world.
template <class IsMeant>
const RecordKind& kind_where(IsMeant is_meant) {
  for (const WorldEntry* entry : all_worlds())
    if (is_meant(*entry->records)) return *entry->records;
  return *all_worlds().front()->records;
}

}  // namespace

const WorldEntry* find_world(std::string_view name) {
  for (const WorldEntry* entry : all_worlds())
    if (entry->name == name || (!name.empty() && entry->former_name == name)) return entry;
  return nullptr;
}

std::shared_ptr<const World> default_world(std::string_view name) { return find_world(name)->make({}).world; }

std::shared_ptr<const World> restore_world(std::string_view name, std::string_view conditions) {
  const WorldEntry* entry = find_world(name);
  const ReadJson json = with_today_names(read_json(conditions));
  if (entry == nullptr || !json.is_object()) return nullptr;
  if (entry->restore != nullptr) return entry->restore(json);
  WorldSettings settings;
  for (const WorldSetting& setting : entry->settings) {
    std::string key(setting.name);
    std::replace(key.begin(), key.end(), '-', '_');
    const auto found = json.find(key);
    const auto text = found == json.end() ? std::nullopt : text_of_setting(setting, *found);
    if (!text) return nullptr;
    settings.emplace(setting.name, *text);
  }
  return entry->make(settings).world;
}

const RecordKind& kind_of_record(std::string_view text) {
  const ReadJson json = read_json(text.substr(0, text.find('\n')));
  return kind_where([&](const RecordKind& kind) {
    return json.is_object() && json.contains("labmouse") && json["labmouse"] == kind.header;
  });
}

const RecordKind& kind_of_packed(const ReadJson& packed) {
  return kind_where([&](const RecordKind& kind) { return packed.is_object() && packed.contains(kind.packed); });
}

std::shared_ptr<const World> first_world() { return all_worlds().front()->make({}).world; }

}  // namespace labmouse
