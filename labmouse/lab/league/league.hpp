// A league: the folder of a season with its practice mazes and entries.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/league/entry_folder.hpp"
#include "labmouse/lab/league/season.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/mice/contestant.hpp"

namespace labmouse {

// What lies in the folder of a league.
inline constexpr const char* season_file_name = "season.toml";
inline constexpr const char* secret_file_name = "secret-seed.txt";
inline constexpr const char* store_file_name = "results.db";
inline constexpr const char* practice_folder_name = "practice";
inline constexpr const char* entries_folder_name = "entries";
inline constexpr const char* records_folder_name = "records";

/// An entry, and the mouse that it is.
struct LeagueEntry {
  EntryManifest manifest;
  std::string folder;  ///< its path
  std::string hash;    ///< as of hash_of_folder()
  Contestant mouse;
};

/// An entry, or errors of its manifest.
struct LeagueEntryResult {
  std::optional<LeagueEntry> entry;
  std::vector<std::string> errors;  ///< one line each, with the place
};

struct League {
  std::string folder;
  Season season;
  std::shared_ptr<const World> world;
  std::vector<NamedMaze> practice;           ///< by name, which is that of the file without its ending
  std::vector<LeagueEntry> entries;          ///< by name
  std::vector<Contestant> builtin;           ///< the built-in mice of that world, which race as a comparison
  std::vector<std::string> secret_files;     ///< with the seed, elsewhere
  std::vector<std::string> errors, remarks;  ///< one line each
  std::vector<std::string> entry_errors;     ///< the same, of entries; these are not among `entries`

  /// Paths that no mouse may see, besides the entries of the others.
  std::vector<std::string> hidden() const;
};

/// Reads the season, its mazes and all entries of a folder.
/// @param options how programs are started; the limits are those of the season.
/// @param secret_files other files that no mouse may see.
League load_league(const std::string& folder, const ExternalOptions& options,
                   std::vector<std::string> secret_files = {});

/// The mazes of the examination: "examination 001", "examination 002" and so on.
std::vector<NamedMaze> examination_mazes(const SecretMazes& mazes, const std::string& secret);

/// Why an examination with that secret seed cannot be held; empty where it can. It names no maze but by its number.
std::string refuse_examination(const World& world, const SecretMazes& mazes, const std::string& secret);

/// Reads the entry in a folder, as a mouse of that league. Its mouse cannot see the other entries.
LeagueEntryResult read_entry(const League& league, const std::string& folder, ExternalOptions options);

}  // namespace labmouse
