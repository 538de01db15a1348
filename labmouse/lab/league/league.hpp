// A league: the folder of a season with its practice mazes and entries.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/league/earlier_seasons.hpp"
#include "labmouse/lab/league/entry_folder.hpp"
#include "labmouse/lab/league/season.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/mice/contestant.hpp"

namespace labmouse {

/// The published results, beside the pages.
inline constexpr const char* results_name = "results.json";

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
  std::string hash;  ///< SHA-256 of the list of frozen files; empty for a season of a labmouse that wrote none
  std::shared_ptr<const World> world;
  std::vector<EarlierSeason> earlier;        ///< the oldest first
  std::vector<NamedMaze> practice;           ///< by name, which is that of the file without its ending
  std::vector<LeagueEntry> entries;          ///< by name
  std::vector<Contestant> builtin;           ///< the built-in mice of that world, which race as a comparison
  std::vector<std::string> other_files;      ///< elsewhere, that no mouse may see
  std::vector<std::string> errors, remarks;  ///< one line each
  std::vector<std::string> entry_errors;     ///< the same, of entries; these are not among `entries`

  /// Paths that no mouse may see, besides the entries of the others.
  std::vector<std::string> hidden() const;
};

/// Reads the season, its mazes and all entries of a folder.
/// @param options how programs are started; the limits are those of the season. It is an error if the system has no
/// sandboxes and they are to be used always.
/// @param other_files files elsewhere that no mouse may see: seeds, stores.
League load_league(const std::string& folder, const ExternalOptions& options,
                   std::vector<std::string> other_files = {});

/// A secret seed, or the error as a line for the user.
struct SecretSeed {
  std::string secret, error;
};

/// Reads the file of a seed.
SecretSeed read_secret_seed(const std::string& path);

/// Reads the seed of the season, and checks that it has the hash in the season file.
/// @param path of its file; empty for that in the folder of the league.
SecretSeed read_secret_seed_of(const League& league, const std::string& path);

/// The results.json of the season before, or an error as a line for the user.
struct PreviousSeason {
  std::string path, content;
  std::vector<EarlierSeason> seasons;
  std::string error;
};

/// Reads the results.json of a season that is over.
/// @param path the file, or the folder that it lies in.
PreviousSeason read_previous_season(const std::string& path);

/// The mazes of the examination: "examination 001", "examination 002" and so on.
std::vector<NamedMaze> examination_mazes(const SecretMazes& mazes, const std::string& secret);

/// Why an examination with that secret seed cannot be held; empty where it can. It names no maze but by its number.
std::string refuse_examination(const World& world, const SecretMazes& mazes, const std::string& secret);

/// Reads the entry in a folder, as a mouse of that league. Its mouse cannot see the other entries.
LeagueEntryResult read_entry(const League& league, const std::string& folder, ExternalOptions options);

}  // namespace labmouse
