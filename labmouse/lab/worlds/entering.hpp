// Which mouse races in which world.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "labmouse/lab/worlds/worlds.hpp"

namespace labmouse {

/// The mice that race in one world.
struct Entry {
  std::shared_ptr<const World> world;
  std::vector<Contestant> mice;
  WorldSettings settings = {};  ///< that the world was made with; others have their defaults
};

/// Where the mice race, or why they cannot: exactly one of the two is there.
struct EntriesResult {
  std::vector<Entry> entries;
  std::string error;
  std::vector<std::string> left_out;      ///< why mice of a mice file are not among them, a line each
  std::vector<std::string> remarks = {};  ///< of the worlds
};

/// All mice race in the world of that name, once for each value of a setting that has several. Where it is empty, each
/// races in the first world on the list that takes it; without mice, the first world has entries. Entries of one world
/// stand together.
EntriesResult enter(std::vector<Contestant> mice, std::string_view world, const WorldSettings& settings);

/// Whether a world has a setting of that name.
bool has(const WorldEntry& entry, std::string_view setting);

/// Makes the world again with the defaults of half-size contests if all mazes are half-size, with a side over 16. Where
/// only some are, the world remains, because a race has one set of conditions, and the result is a remark about that.
std::string suit_defaults(Entry& entry, std::span<const NamedMaze> mazes);

/// Why one of these settings counts in none of the worlds that the mice race in; empty where each counts in one.
std::string unused_setting(const std::vector<Entry>& entries, const WorldSettings& given);

/// Whether a world has several entries: a setting has several values.
bool has_several_values(const std::vector<Entry>& entries);

/// An error if the entries are of different worlds: which mice race in which, which worlds would take all mice, and
/// `advice` on what else to do. Empty if all are of one world.
std::string different_worlds(const std::vector<Entry>& entries, std::string_view advice);

/// The only entry with mice; an error if several entries have mice, or a setting has several values.
EntriesResult sole_entry(std::vector<Entry> entries);

/// The built-in mice that the world takes.
std::vector<Contestant> residents_of(const World& world);

/// Removes the mazes in which the world runs no contests, and adds them to the skipped ones. If the user named one of
/// them directly, returns its name and why it was removed; otherwise an empty string.
std::string leave_out(const World& world, const std::vector<std::string>& named, MazeCollection& mazes);

}  // namespace labmouse
