#include "labmouse/lab/league/league.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "labmouse/external/sandbox.hpp"
#include "labmouse/functions/sha256.hpp"
#include "labmouse/lab/league/frozen_files.hpp"
#include "labmouse/lab/mazes/secret_mazes.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/system/file_names.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/lab/worlds/entering.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

/// The folders in the folder, without hidden ones.
std::vector<std::string> folders_in(const std::string& folder) {
  std::vector<std::string> folders;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (!entry->path().filename().string().starts_with('.') && entry->is_directory(error))
      folders.push_back(entry->path().string());
  std::sort(folders.begin(), folders.end());
  return folders;
}

std::string entries_folder(const League& league) { return fmt::format("{}/{}", league.folder, entries_folder_name); }

/// Why the mouse cannot race in the season; empty where it can.
std::string refuse(const League& league, const EntryManifest& manifest, const Contestant& mouse) {
  const auto same = [&](const Contestant& other) { return other.name == manifest.name; };
  if (std::any_of(league.builtin.begin(), league.builtin.end(), same))
    return fmt::format("'{}' is the name of a built-in mouse; choose another name", manifest.name);
  const auto robot = league.season.world.settings.find(std::string_view("robot"));
  if (!manifest.robot.empty() && robot != league.season.world.settings.end() && robot->second != manifest.robot)
    return fmt::format("the entry is made for the robot '{}', and the season is that of '{}'", manifest.robot,
                       robot->second);
  return league.world->refuse(mouse);
}

void load_earlier(League& league) {
  const std::string path = fmt::format("{}/{}", league.folder, previous_file_name);
  std::error_code unknown;
  if (fs::symlink_status(path, unknown).type() == fs::file_type::not_found) return;
  PreviousSeason previous = read_previous_season(path);
  if (!previous.error.empty()) league.errors.push_back(std::move(previous.error));
  league.earlier = std::move(previous.seasons);
}

/// Compares the frozen files with the list of them.
void check_frozen(League& league, const std::string& season_file) {
  const std::string path = fmt::format("{}/{}", league.folder, frozen_file_name);
  std::error_code unknown;
  if (fs::symlink_status(path, unknown).type() == fs::file_type::not_found && !league.season.is_frozen) {
    league.remarks.push_back(shown(fmt::format("{} is missing: nothing shows whether the season has changed.", path)));
    return;
  }
  const FileContent written = read_found_file(path);
  const FrozenFiles now = frozen_files(league.folder, league.season, season_file);
  if (!written.error.empty())
    league.errors.push_back(shown(fmt::format("{}: error: {}", path, written.error)));
  else if (!now.error.empty())
    league.errors.push_back(now.error);
  else
    league.errors = frozen_changes(league.folder, written.content, now.list);
  league.hash = sha256_text(written.content);
}

void load_practice(League& league) {
  const std::string folder = fmt::format("{}/{}", league.folder, practice_folder_name);
  MazeCollection found = load_mazes(std::vector{folder});
  for (const auto* files : {&found.errors, &found.skipped})
    for (const SkippedFile& file : *files)
      for (const Problem& problem : file.problems) league.errors.push_back(describe(file.path, problem));
  for (NamedMaze& maze : found.mazes) {
    const std::string path = maze.name;
    maze.name = stem_of(path);
    std::string reason = league.world->refuse(maze.maze);
    if (reason.empty() && !league.world->facts(maze.maze).bound) reason = "no mouse can score in this maze";
    if (!reason.empty()) league.errors.push_back(shown(fmt::format("{}: error: {}", path, reason)));
    league.practice.push_back(std::move(maze));
  }
  if (found.mazes.empty() && league.errors.empty())
    league.errors.push_back(shown(fmt::format("{}: error: has no mazes", folder)));
}

SecretSeed seed_in(const std::string& path, const FileContent& file) {
  const auto failed = [&](const std::string& reason) {
    return SecretSeed{"", shown(fmt::format("{}: error: {}", path, reason))};
  };
  if (!file.error.empty()) return failed(file.error + "; name the file of the seed with --seed-file");
  std::string secret = secret_in(file.content);
  if (secret.size() < shortest_secret)
    return failed(fmt::format("the seed has fewer than {} characters, so that it could be guessed", shortest_secret));
  return {std::move(secret), ""};
}

}  // namespace

std::vector<std::string> League::hidden() const {
  std::vector<std::string> paths;
  for (const char* name : {season_file_name, frozen_file_name, secret_file_name, store_file_name, practice_folder_name,
                           records_folder_name})
    paths.push_back(fmt::format("{}/{}", folder, name));
  paths.insert(paths.end(), other_files.begin(), other_files.end());
  return paths;
}

LeagueEntryResult read_entry(const League& league, const std::string& folder, ExternalOptions options) {
  const std::string path = fmt::format("{}/{}", folder, manifest_name);
  const FileContent file = read_found_file(path);
  if (!file.error.empty())
    return {{}, {shown(fmt::format("{}: error: {}; an entry needs this file", path, file.error))}};
  const EntryManifestResult manifest = read_manifest(file.content);
  LeagueEntryResult result;
  for (const Problem& problem : manifest.problems) result.errors.push_back(describe(path, problem));
  if (!result.errors.empty()) return result;
  options.limits = league.season.limits;
  options.runs = 1;
  auto [hash, error] = hash_of_folder(folder);
  if (!error.empty()) return {{}, {std::move(error)}};
  options.label = hash;
  options.hidden = std::make_shared<HiddenFiles>();
  for (const std::string& hidden : league.hidden()) options.hidden->add_store(hidden);
  for (const std::string& other : folders_in(entries_folder(league)))
    if (!is_same_file(other, folder)) options.hidden->add(other);
  SpecResult read = read_specs("mice-file:" + path, options);
  if (!read.error.empty()) return {{}, {shown("error: " + read.error)}};
  Contestant& mouse = read.contestants.front();
  if (const std::string reason = refuse(league, manifest.entry, mouse); !reason.empty())
    return {{}, {shown(fmt::format("{}: error: {}", path, reason))}};
  mouse.runs = 1;
  return {LeagueEntry{manifest.entry, folder, hash, std::move(mouse)}, {}};
}

PreviousSeason read_previous_season(const std::string& path) {
  PreviousSeason previous;
  std::error_code unknown;
  previous.path = fs::is_directory(path, unknown) ? fmt::format("{}/{}", path, results_name) : path;
  FileContent file = read_found_file(previous.path, most_results_bytes);
  std::string error = std::move(file.error);
  if (error.empty()) {
    EarlierSeasonsResult read = read_earlier_seasons(file.content);
    previous.seasons = std::move(read.seasons);
    error = std::move(read.error);
  }
  previous.content = std::move(file.content);
  if (!error.empty()) previous.error = shown(fmt::format("{}: error: {}", previous.path, error));
  return previous;
}

std::vector<NamedMaze> examination_mazes(const SecretMazes& mazes, const std::string& secret) {
  std::vector<NamedMaze> all;
  for (int number = 1; number <= mazes.count; ++number) {
    std::string name = fmt::format("examination {:03}", number);
    const Maze maze = secret_maze(mazes, secret, name);
    all.push_back({std::move(name), maze});
  }
  return all;
}

std::string refuse_examination(const World& world, const SecretMazes& mazes, const std::string& secret) {
  std::size_t number = 0;
  for (const NamedMaze& maze : examination_mazes(mazes, secret)) {
    ++number;
    std::string reason = world.refuse(maze.maze);
    if (reason.empty() && !world.facts(maze.maze).bound) reason = "no mouse can score in it";
    if (!reason.empty()) return fmt::format("maze {} of the examination: {}; choose other mazes", number, reason);
  }
  return "";
}

SecretSeed read_secret_seed(const std::string& path) { return seed_in(path, read_file(path)); }

SecretSeed read_secret_seed_of(const League& league, const std::string& path) {
  const std::string own = fmt::format("{}/{}", league.folder, secret_file_name);
  const std::string& file = path.empty() ? own : path;
  SecretSeed seed = path.empty() ? seed_in(own, read_found_file(own)) : read_secret_seed(path);
  if (seed.error.empty() && sha256_text(seed.secret) != league.season.seed_hash)
    return {"", shown(fmt::format("{}: error: the hash of this seed is not that of the season, {}", file,
                                  league.season.seed_hash))};
  return seed;
}

League load_league(const std::string& folder, const ExternalOptions& options, std::vector<std::string> other_files) {
  League league;
  league.folder = folder;
  league.other_files = std::move(other_files);
  if (options.sandbox == SandboxUse::always && !why_no_sandbox().empty()) {
    league.errors.push_back(fmt::format(
        "error: this system has no sandboxes ({}); --sandbox off runs programs without one, and the results say so",
        why_no_sandbox()));
    return league;
  }
  const std::string path = fmt::format("{}/{}", folder, season_file_name);
  const FileContent file = read_found_file(path);
  if (!file.error.empty()) {
    league.errors.push_back(
        shown(fmt::format("{}: error: {}; `labmouse league init` makes a season", path, file.error)));
    return league;
  }
  SeasonResult season = read_season(file.content);
  for (const Problem& problem : season.problems) league.errors.push_back(describe(path, problem));
  if (!league.errors.empty()) return league;
  league.season = std::move(season.season);
  if (!league.season.version.empty() && league.season.version != version())
    league.remarks.push_back(shown(fmt::format(
        "The season was made by labmouse {}, and this is {}: results may differ.", league.season.version, version())));
  check_frozen(league, file.content);
  if (!league.errors.empty()) return league;
  WorldResult made = make_world(league.season.world, folder);
  league.world = std::move(made.world);
  league.remarks.insert(league.remarks.end(), made.remarks.begin(), made.remarks.end());
  if (!made.error.empty()) league.errors.push_back(fmt::format("{}: {}", shown(path), made.error));
  if (league.world == nullptr) return league;
  if (const std::string reason = refuse_for_league(*league.world); !reason.empty())
    league.errors.push_back(fmt::format("{}: error: {}", shown(path), reason));
  load_earlier(league);
  league.builtin = residents_of(*league.world);
  load_practice(league);
  for (const std::string& entry : folders_in(entries_folder(league))) {
    LeagueEntryResult read = read_entry(league, entry, options);
    league.entry_errors.insert(league.entry_errors.end(), read.errors.begin(), read.errors.end());
    if (read.entry) league.entries.push_back(std::move(*read.entry));
  }
  const auto name = [](const LeagueEntry& entry) -> const std::string& { return entry.manifest.name; };
  std::sort(league.entries.begin(), league.entries.end(),
            [&](const LeagueEntry& a, const LeagueEntry& b) { return name(a) < name(b); });
  for (std::size_t i = 1; i < league.entries.size(); ++i)
    if (name(league.entries[i]) == name(league.entries[i - 1]))
      league.entry_errors.push_back(shown(fmt::format("{}: error: another entry has the name '{}'; give each its own",
                                                      league.entries[i].folder, name(league.entries[i]))));
  return league;
}

}  // namespace labmouse
