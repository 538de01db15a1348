#include "labmouse/lab/worlds/entering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/text/commas.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// A built-in mouse with the defaults of its parameters; any other mouse unchanged.
Contestant bare(const Contestant& mouse) {
  const BuiltinMouse* entry = entry_of(mouse);
  if (entry == nullptr) return mouse;
  std::vector<Contestant> all = all_contestants();
  return *std::find_if(all.begin(), all.end(), [&](const Contestant& each) { return entry_of(each) == entry; });
}

/// The place on the list of the first world that takes a mouse; the list's length where none does.
std::size_t place_of(const Contestant& mouse) {
  std::size_t place = 0;
  while (place < all_worlds().size() && !all_worlds()[place]->make({}).world->refuse(mouse).empty()) ++place;
  return place;
}

EntriesResult enter_one(std::vector<Contestant> mice, const WorldEntry& entry, const WorldSettings& settings) {
  WorldResult made = entry.make(settings);
  if (!made.error.empty()) return {{}, made.error, {}};
  EntriesResult result;
  result.remarks = std::move(made.remarks);
  std::vector<Contestant> taken;
  for (Contestant& mouse : mice) {
    const std::string reason = made.world->refuse(mouse);
    if (!reason.empty() && mouse.mice_file.empty()) return {{}, "error: " + reason, {}};
    if (reason.empty())
      taken.push_back(std::move(mouse));
    else
      result.left_out.push_back(reason);
  }
  if (taken.empty() && !result.left_out.empty()) return {{}, "error: " + result.left_out.front(), {}};
  result.entries.push_back({std::move(made.world), std::move(taken), settings});
  return result;
}

bool is_half_size(const NamedMaze& maze) {
  constexpr int classic_side = 16;
  const Size size = maze.maze.size();
  return std::max(size.width, size.height) > classic_side;
}

/// "with --world physical or --world failures"
std::string worlds_with(std::string_view setting) {
  std::string text;
  for (const WorldEntry* entry : all_worlds())
    if (has(*entry, setting)) text += fmt::format("{} --world {}", text.empty() ? "with" : " or", entry->name);
  return text;
}

/// One set of settings for each value of those that may have several.
std::vector<WorldSettings> each_of(const WorldEntry& entry, const WorldSettings& settings) {
  std::vector<WorldSettings> all = {settings};
  for (const WorldSetting& setting : entry.settings) {
    const auto given = settings.find(setting.name);
    if (!setting.listed || given == settings.end()) continue;
    std::vector<WorldSettings> more;
    for (const WorldSettings& chosen : all)
      for (std::string& value : between_commas(given->second)) {
        more.push_back(chosen);
        more.back()[given->first] = std::move(value);
      }
    all = std::move(more);
  }
  return all;
}

/// "'flood'", or "'flood' and 4 others".
std::string named(const std::vector<Contestant>& mice) {
  const std::string first = fmt::format("'{}'", mice.front().name);
  return mice.size() == 1 ? first : fmt::format("{} and {}", first, counted(std::ssize(mice) - 1, "other", "others"));
}

/// The worlds that take all mice of the entries: "--world seconds or --world physical"; empty for none.
std::string worlds_for_all(const std::vector<Entry>& entries) {
  std::string text;
  for (const WorldEntry* each : all_worlds()) {
    const auto world = each->make({}).world;
    const bool all = std::all_of(entries.begin(), entries.end(), [&](const Entry& entry) {
      return std::all_of(entry.mice.begin(), entry.mice.end(),
                         [&](const Contestant& mouse) { return world->refuse(mouse).empty(); });
    });
    if (all) text += fmt::format("{}--world {}", text.empty() ? "" : " or ", each->name);
  }
  return text;
}

bool in_same_world(const Entry& one, const Entry& other) {
  return one.world->traits().name == other.world->traits().name;
}

/// An error if a setting with several values has an empty one, as in "classic,".
std::string empty_value(const WorldEntry& entry, const WorldSettings& settings) {
  for (const WorldSetting& setting : entry.settings) {
    const auto given = settings.find(setting.name);
    if (!setting.listed || given == settings.end()) continue;
    const std::vector<std::string> values = between_commas(given->second);
    if (std::find(values.begin(), values.end(), "") != values.end())
      return fmt::format("error: --{}: '{}' has an empty value; write values with a comma between them", setting.name,
                         shown(given->second));
  }
  return "";
}

/// A race for each value of the settings that may have several.
EntriesResult enter_each(const std::vector<Contestant>& mice, const WorldEntry& entry, const WorldSettings& settings) {
  if (std::string error = empty_value(entry, settings); !error.empty()) return {{}, std::move(error), {}};
  EntriesResult result;
  for (const WorldSettings& chosen : each_of(entry, settings)) {
    EntriesResult one = enter_one(mice, entry, chosen);
    if (!one.error.empty()) return one;
    // Mice are left out for the same reasons under all values, so those of the first are enough.
    if (result.entries.empty()) result.left_out = std::move(one.left_out);
    for (std::string& remark : one.remarks)
      if (std::find(result.remarks.begin(), result.remarks.end(), remark) == result.remarks.end())
        result.remarks.push_back(std::move(remark));
    std::move(one.entries.begin(), one.entries.end(), std::back_inserter(result.entries));
  }
  return result;
}

}  // namespace

bool has(const WorldEntry& entry, std::string_view setting) {
  return std::any_of(entry.settings.begin(), entry.settings.end(),
                     [&](const WorldSetting& each) { return each.name == setting; });
}

std::string suit_defaults(Entry& entry, std::span<const NamedMaze> mazes) {
  const auto large = std::count_if(mazes.begin(), mazes.end(), is_half_size);
  const bool all_large = large > 0 && large == std::ssize(mazes);
  const WorldEntry& world = *find_world(entry.world->traits().name);
  std::string remark;
  for (const WorldSetting& setting : world.settings) {
    if (setting.half_size_default.empty() || entry.settings.contains(setting.name)) continue;
    entry.settings[std::string(setting.name)] = all_large ? setting.half_size_default : setting.default_value;
    if (all_large) entry.world = world.make(entry.settings).world;
    if (large > 0 && !all_large)
      remark = fmt::format(
          "{} of {} mazes are half-size (a side over 16), but a race has one set of {}: {} for all; for {}, race them "
          "alone or give --{}",
          large, mazes.size(), setting.name, setting.default_value, setting.half_size_default, setting.name);
  }
  return remark;
}

EntriesResult enter(std::vector<Contestant> mice, std::string_view world, const WorldSettings& settings) {
  if (mice.empty() && world.empty()) world = all_worlds().front()->name;
  if (!world.empty()) return enter_each(mice, *find_world(world), settings);
  std::vector<std::vector<Contestant>> by_world(all_worlds().size());
  for (Contestant& mouse : mice) {
    const std::size_t place = place_of(mouse);
    if (place == by_world.size())
      return {{}, fmt::format("error: mouse '{}' cannot race in any world", mouse.name), {}};
    // A parameter must not change the world of a mouse without notice.
    if (const std::size_t usual = place > 0 ? place_of(bare(mouse)) : place; usual != place)
      return {{},
              fmt::format("error: {}; leave it out, or add --world {}",
                          all_worlds()[usual]->make({}).world->refuse(mouse), all_worlds()[place]->name),
              {}};
    by_world[place].push_back(std::move(mouse));
  }
  EntriesResult result;
  for (std::size_t i = 0; i < by_world.size(); ++i) {
    if (by_world[i].empty()) continue;
    EntriesResult one = enter_each(by_world[i], *all_worlds()[i], settings);
    if (!one.error.empty()) return one;
    std::move(one.entries.begin(), one.entries.end(), std::back_inserter(result.entries));
    std::move(one.remarks.begin(), one.remarks.end(), std::back_inserter(result.remarks));
  }
  return result;
}

std::string unused_setting(const std::vector<Entry>& entries, const WorldSettings& given) {
  for (const WorldEntry* owner : all_worlds())
    for (const WorldSetting& setting : owner->settings) {
      if (!given.contains(setting.name)) continue;
      const bool used = std::any_of(entries.begin(), entries.end(), [&](const Entry& entry) {
        return has(*find_world(entry.world->traits().name), setting.name);
      });
      if (!used) return fmt::format("error: --{} has no effect here, only {}", setting.name, worlds_with(setting.name));
    }
  return "";
}

bool has_several_values(const std::vector<Entry>& entries) {
  return std::adjacent_find(entries.begin(), entries.end(), in_same_world) != entries.end();
}

std::string different_worlds(const std::vector<Entry>& entries, std::string_view advice) {
  std::string suited;
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (i == 0 || !in_same_world(entries[i - 1], entries[i]))
      suited += fmt::format("{}{} in the world {}", suited.empty() ? "" : ", ", named(entries[i].mice),
                            entries[i].world->traits().name);
  if (entries.empty() || in_same_world(entries.front(), entries.back())) return "";
  const std::string worlds = worlds_for_all(entries);
  return fmt::format("error: these mice race in different worlds: {}; {}{}", suited,
                     worlds.empty() ? "" : fmt::format("choose {}, in which all can race, or ", worlds), advice);
}

EntriesResult sole_entry(std::vector<Entry> entries) {
  if (has_several_values(entries))
    return {{}, "error: only `labmouse race` takes several values, separated by commas; give one", {}};
  std::erase_if(entries, [](const Entry& entry) { return entry.mice.empty(); });
  if (std::string error = different_worlds(entries, "name mice of one world"); !error.empty()) return {{}, error, {}};
  return {std::move(entries), "", {}};
}

std::vector<Contestant> residents_of(const World& world) {
  std::vector<Contestant> mice = all_contestants();
  // Mice that cannot race in steps differ from the others only in worlds with errors.
  std::erase_if(mice, [&](const Contestant& mouse) {
    return !world.refuse(mouse).empty() || (!mouse.walks() && !world.traits().is_stochastic);
  });
  return mice;
}

std::string leave_out(const World& world, const std::vector<std::string>& named, MazeCollection& mazes) {
  std::string error;
  std::erase_if(mazes.mazes, [&](const NamedMaze& maze) {
    const std::string reason = world.refuse(maze.maze);
    if (reason.empty()) return false;
    if (error.empty() && std::find(named.begin(), named.end(), maze.name) != named.end())
      error = fmt::format("{}: error: {}", maze.name, reason);
    mazes.skipped.push_back({maze.name, {{no_place, no_place, reason}}});
    return true;
  });
  return error;
}

}  // namespace labmouse
