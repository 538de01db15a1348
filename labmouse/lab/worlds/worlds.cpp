#include "labmouse/lab/worlds/worlds.hpp"

namespace labmouse {

const WorldEntry* find_world(std::string_view name) {
  for (const WorldEntry* entry : all_worlds())
    if (entry->name == name) return entry;
  return nullptr;
}

std::shared_ptr<const World> default_world(std::string_view name) { return find_world(name)->make({}).world; }

std::shared_ptr<const World> home_world() { return all_worlds().front()->make({}).world; }

}  // namespace labmouse
