#include "labmouse/lab/page/page_world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/races/value_json.hpp"
#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/worlds/worlds.hpp"

namespace labmouse {
namespace {

/// The value of a setting in the request, as text.
std::string setting_in(PageRequest& request, const WorldSetting& setting, const std::string& key) {
  if (setting.kind == WorldSetting::Kind::flag) return request.flag(key.c_str()) ? "true" : "false";
  if (setting.kind == WorldSetting::Kind::whole) {
    const auto most = std::min(setting.high, double{most_page_steps});
    return fmt::format("{}", request.whole(key.c_str(), static_cast<int>(setting.low), static_cast<int>(most)));
  }
  std::string text = request.text(key.c_str());
  const bool has_text = text.find('\n') != std::string::npos;
  if (!has_text && (text.find('/') != std::string::npos || text.ends_with(".toml") || text == "-"))
    request.reject(fmt::format("'{}' is a file, which the page cannot read", key));
  return text;
}

}  // namespace

Entry read_page_world(PageRequest& request) {
  const std::string name = request.has("world") ? request.text("world") : std::string(all_worlds().front()->name);
  const WorldEntry* entry = find_world(name);
  if (entry == nullptr) {
    request.reject(fmt::format("unknown world '{}'", name));
    return {};
  }
  WorldSettings settings;
  for (const WorldSetting& setting : entry->settings)
    for (const std::string& key : {std::string(setting.name), std::string(former_key(key_of(setting)))})
      if (request.has(key.c_str())) settings[std::string(setting.name)] = setting_in(request, setting, key);
  std::erase_if(settings, [](const auto& setting) { return setting.second == by_maze_size; });
  if (!request.error().empty()) return {};
  WorldResult made = entry->make(settings);
  if (!made.error.empty()) request.reject(made.error);
  return {std::move(made.world), {}, std::move(settings)};
}

Json again_json(const World& world) {
  Json mice = Json::array();
  for (const Contestant& mouse : all_contestants())
    if (entry_of(mouse) != nullptr && world.refuse(mouse).empty()) mice.push_back(mouse.name);
  return {{"with", {{"world", world.traits().name}, {"conditions", conditions_json(world)}}},
          {"mice", std::move(mice)}};
}

Json play_of(const Replay& replay) {
  Json play = replay.play();
  if (const auto recorded = replay.world())
    if (const auto world = restore_world(recorded->name, recorded->conditions.dump()))
      play["again"] = again_json(*world);
  return play;
}

}  // namespace labmouse
