#include "labmouse/lab/races/world_entry.hpp"

#include <algorithm>

namespace labmouse {

std::string value_of(const WorldEntry& entry, const WorldSettings& settings, std::string_view name) {
  if (const auto found = settings.find(name); found != settings.end()) return found->second;
  const auto setting = std::find_if(entry.settings.begin(), entry.settings.end(),
                                    [&](const WorldSetting& each) { return each.name == name; });
  return std::string(setting->default_value);
}

}  // namespace labmouse
