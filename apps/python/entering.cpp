#include "entering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "errors.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse::python {
namespace {

void require_world(const std::string& name) {
  if (name.empty() || find_world(name) != nullptr) return;
  std::vector<std::string_view> names;
  for (const WorldEntry* entry : all_worlds()) names.push_back(entry->name);
  const auto near = nearest_name(name, names);
  throw UserError(near.empty() ? fmt::format("unknown world '{}'; the worlds are {}", name, fmt::join(names, ", "))
                               : fmt::format("unknown world '{}'; did you mean '{}'?", name, near));
}

/// "; did you mean 'noise'?", or nothing.
std::string nearest_setting(const std::string& name) {
  std::vector<std::string_view> names = {"world"};
  for (const WorldEntry* entry : all_worlds())
    for (const WorldSetting& setting : entry->settings) names.push_back(setting.name);
  const auto near = nearest_name(name, names);
  return near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
}

void require_known_settings(const WorldSettings& settings) {
  for (const auto& [name, value] : settings)
    if (std::none_of(all_worlds().begin(), all_worlds().end(),
                     [&name = name](const WorldEntry* entry) { return has(*entry, name); }))
      throw UserError(fmt::format("no world has the setting '{}'{}", name, nearest_setting(name)));
}

std::vector<Entry> entries_of(EntriesResult result, std::vector<std::string>& remarks) {
  if (!result.error.empty()) throw UserError(result.error);
  for (const std::string& reason : result.left_out) remarks.push_back("left out: " + reason);
  for (const std::string& remark : result.remarks) remarks.push_back("remark: " + remark);
  return std::move(result.entries);
}

void require_good_name(const std::string& name) {
  if (name.empty()) throw UserError("a mouse has an empty name; give it one, as in {'name': mouse}");
  if (shown(name) != name) throw UserError(fmt::format("the name '{}' contains unprintable characters", shown(name)));
}

std::vector<Contestant> mice_by(SpecResult read) {
  if (!read.problems.empty()) throw UserError(fmt::format("{}", fmt::join(read.problems, "\n")));
  if (!read.error.empty()) throw UserError(read.error);
  return std::move(read.contestants);
}

/// The mice of SPECs. Names are given beside the SPECs, not in them, because they may have any characters.
std::vector<Contestant> mice_by_specs(const Choice& choice, const ExternalOptions& options) {
  std::vector<std::string> nameless;
  std::vector<Contestant> mice;
  for (const auto& [name, spec] : choice.specs) {
    if (name.empty()) {
      nameless.push_back(spec);
      continue;
    }
    std::vector<Contestant> named = mice_by(read_specs(spec, options));
    if (named.size() != 1)
      throw UserError(fmt::format("'{}' names {} mice; for the name '{}', give exactly one", spec, named.size(), name));
    rename(named.front(), name);
    mice.push_back(std::move(named.front()));
  }
  if (nameless.empty()) return mice;
  std::vector<Contestant> others = mice_by(read_specs(nameless, options));
  std::move(others.begin(), others.end(), std::back_inserter(mice));
  return mice;
}

std::vector<Contestant> mice_of(Choice& choice, const std::atomic<bool>* stop) {
  ExternalOptions options;
  options.python = choice.python;
  options.label = choice.label;
  options.stop = stop;
  std::vector<Contestant> mice = mice_by_specs(choice, options);
  for (OwnMouse& own : choice.own) mice.push_back(python_contestant(std::move(own), stop));
  std::vector<std::string> names;
  for (const Contestant& mouse : mice) names.push_back(mouse.name);
  std::for_each(names.begin(), names.end(), require_good_name);
  std::sort(names.begin(), names.end());
  if (const auto twice = std::adjacent_find(names.begin(), names.end()); twice != names.end())
    throw UserError(
        fmt::format("two mice are named '{}'; give each a name of its own, as in {{'name': mouse}}", *twice));
  return mice;
}

/// Sorts mazes by name and removes duplicates; throws UserError if two different mazes have the same name.
void require_names(std::vector<NamedMaze>& mazes) {
  std::stable_sort(mazes.begin(), mazes.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  for (std::size_t i = 1; i < mazes.size(); ++i)
    if (mazes[i].name == mazes[i - 1].name && mazes[i].maze != mazes[i - 1].maze)
      throw UserError(fmt::format("two different mazes are named '{}'; give each a name of its own with Maze.named",
                                  mazes[i].name));
  const auto same = [](const auto& a, const auto& b) { return a.name == b.name; };
  mazes.erase(std::unique(mazes.begin(), mazes.end(), same), mazes.end());
}

}  // namespace

Entry world_of(const std::string& world, const WorldSettings& settings) {
  require_world(world);
  require_known_settings(settings);
  std::vector<std::string> remarks;
  const std::string_view name = world.empty() ? all_worlds().front()->name : std::string_view(world);
  std::vector<Entry> entries = entries_of(labmouse::enter({}, name, settings), remarks);
  entries_of(sole_entry(entries), remarks);
  if (const std::string unused = unused_setting(entries, settings); !unused.empty()) throw UserError(unused);
  return std::move(entries.front());
}

Field enter(Choice choice, const std::atomic<bool>* stop) {
  require_world(choice.world);
  require_known_settings(choice.settings);
  Field field;
  std::vector<Contestant> mice = mice_of(choice, stop);
  if (mice.empty()) {
    mice = residents_of(*world_of(choice.world, choice.settings).world);
    if (mice.empty())
      throw UserError(fmt::format("labmouse has no built-in mice for the world {}; name your own", choice.world));
  }
  std::vector<Entry> entries =
      entries_of(labmouse::enter(std::move(mice), choice.world, choice.settings), field.remarks);
  if (const std::string unused = unused_setting(entries, choice.settings); !unused.empty()) throw UserError(unused);
  field.entry = std::move(entries_of(sole_entry(std::move(entries)), field.remarks).front());
  MazeCollection mazes = choice.mazes.empty() ? load_builtin_mazes() : MazeCollection();
  if (!choice.mazes.empty()) mazes.mazes = std::move(choice.mazes);
  require_names(mazes.mazes);
  std::vector<std::string> named;
  for (const NamedMaze& maze : mazes.mazes) named.push_back(maze.name);
  const std::string refused = leave_out(*field.entry.world, named, mazes);
  // A built-in maze that was not named is left out, as on the command line.
  if (mazes.mazes.empty())
    throw UserError(refused.empty() ? fmt::format("no mazes to race on: none of these can be used in the world {}",
                                                  field.entry.world->traits().name)
                                    : refused);
  field.mazes = std::move(mazes.mazes);
  if (const std::string remark = suit_defaults(field.entry, field.mazes); !remark.empty())
    field.remarks.push_back("remark: " + remark);
  field.skipped = std::move(mazes.skipped);
  return field;
}

}  // namespace labmouse::python
