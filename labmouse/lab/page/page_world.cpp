#include "labmouse/lab/page/page_world.hpp"

#include <fmt/format.h>

#include "labmouse/lab/worlds/worlds.hpp"

namespace labmouse {
namespace {

/// What the request says of a setting, as text.
std::string setting_in(PageRequest& request, const WorldSetting& setting) {
  const std::string key(setting.name);
  if (setting.kind == WorldSetting::Kind::flag) return request.flag(key.c_str()) ? "true" : "false";
  if (setting.kind == WorldSetting::Kind::whole) {
    const auto most = std::min<std::int64_t>(setting.high, most_page_steps);
    return fmt::format("{}", request.whole(key.c_str(), static_cast<int>(setting.low), static_cast<int>(most)));
  }
  std::string text = request.text(key.c_str());
  const bool has_text = text.find('\n') != std::string::npos;
  if (!has_text && (text.find('/') != std::string::npos || text.ends_with(".toml") || text == "-"))
    request.reject(fmt::format("'{}' is a file, which the page cannot read", key));
  return text;
}

}  // namespace

std::shared_ptr<const World> read_page_world(PageRequest& request) {
  const std::string name = request.has("world") ? request.text("world") : std::string(all_worlds().front()->name);
  const WorldEntry* entry = find_world(name);
  if (entry == nullptr) {
    request.reject(fmt::format("unknown world '{}'", name));
    return nullptr;
  }
  WorldSettings settings;
  for (const WorldSetting& setting : entry->settings)
    if (request.has(std::string(setting.name).c_str()))
      settings[std::string(setting.name)] = setting_in(request, setting);
  if (!request.error().empty()) return nullptr;
  WorldResult made = entry->make(settings);
  if (!made.error.empty()) request.reject(made.error);
  return made.world;
}

}  // namespace labmouse
