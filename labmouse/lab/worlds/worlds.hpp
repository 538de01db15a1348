// All worlds: the one list of them. docs/how-to/add-a-world.md shows what another one takes.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "labmouse/lab/races/world_entry.hpp"
#include "labmouse/lab/replays/replay.hpp"

namespace labmouse {

/// The world that is meant where none is named comes first.
std::span<const WorldEntry* const> all_worlds();
/// The world that has or had that name, or null.
const WorldEntry* find_world(std::string_view name);
/// The world of that name with its defaults; the name must be that of one.
std::shared_ptr<const World> default_world(std::string_view name);
/// The world of that name under these conditions, an object of JSON as World::conditions has them; null where there is
/// no such world, or no such conditions.
std::shared_ptr<const World> restore_world(std::string_view name, std::string_view conditions);
/// The first world with its defaults.
std::shared_ptr<const World> first_world();

/// The kind of record that a text is meant to be, by its first line; that of the first world where it names none.
const RecordKind& kind_of_record(std::string_view text);
/// The kind of a record that a report carries.
const RecordKind& kind_of_packed(const ReadJson& packed);

}  // namespace labmouse
