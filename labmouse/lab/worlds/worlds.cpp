#include "labmouse/lab/worlds/worlds.hpp"

#include <algorithm>

#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {
namespace {

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
  JsonFields fields(json, "");
  for (const WorldSetting& setting : entry->settings)
    if (!setting.later || fields.has(key_of(setting).c_str()))
      settings.emplace(setting.name, text_of(read_value(setting, fields)));
  return fields.error().empty() ? entry->make(settings).world : nullptr;
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
