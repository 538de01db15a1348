#include "labmouse/lab/races/world_entry.hpp"

#include <algorithm>
#include <limits>

#include "labmouse/functions/parse_number.hpp"

namespace labmouse {

std::string value_of(const WorldEntry& entry, const WorldSettings& settings, std::string_view name) {
  if (const auto found = settings.find(name); found != settings.end()) return found->second;
  const auto setting = std::find_if(entry.settings.begin(), entry.settings.end(),
                                    [&](const WorldSetting& each) { return each.name == name; });
  return std::string(setting->default_value);
}

int whole_of(const WorldEntry& entry, const WorldSettings& settings, std::string_view name) {
  constexpr double most = std::numeric_limits<int>::max();
  return static_cast<int>(parse_number(value_of(entry, settings, name), 0.0, most).value_or(0.0));
}

}  // namespace labmouse
