#include "labmouse/lab/worlds/worlds.hpp"

#include <algorithm>
#include <array>

#include "labmouse/lab/mms/mms_entry.hpp"
#include "labmouse/lab/seconds/seconds_entry.hpp"
#include "labmouse/lab/steps/steps_entry.hpp"

namespace labmouse {
namespace {

constexpr std::array<const WorldEntry*, 3> worlds = {&steps_entry, &seconds_entry, &mms_entry};

}  // namespace

std::span<const WorldEntry* const> all_worlds() { return worlds; }

const WorldEntry* find_world(std::string_view name) {
  const auto found =
      std::find_if(worlds.begin(), worlds.end(), [&](const WorldEntry* entry) { return entry->name == name; });
  return found == worlds.end() ? nullptr : *found;
}

std::shared_ptr<const World> default_world(std::string_view name) { return find_world(name)->make({}).world; }

std::shared_ptr<const World> home_world() { return worlds.front()->make({}).world; }

}  // namespace labmouse
