// Season files: the world, mazes and limits of a league. docs/reference/files.md describes them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/external/limits.hpp"
#include "labmouse/lab/mazes/secret_mazes.hpp"
#include "labmouse/lab/worlds/world_table.hpp"

namespace labmouse {

// What lies in the folder of a league.
inline constexpr const char* season_file_name = "season.toml";
inline constexpr const char* frozen_file_name = "season.sha256";
inline constexpr const char* secret_file_name = "secret-seed.txt";
inline constexpr const char* previous_file_name = "previous-season.json";
inline constexpr const char* store_file_name = "results.db";
inline constexpr const char* practice_folder_name = "practice";
inline constexpr const char* entries_folder_name = "entries";
inline constexpr const char* records_folder_name = "records";

/// A season file, as written.
struct Season {
  std::string title;
  std::string version;     ///< of labmouse, which wrote the file
  bool is_frozen = false;  ///< whether it has a list of the frozen files; seasons of earlier versions have none
  NamedWorld world;
  SecretMazes examination = {.count = 20};
  std::string seed_hash;  ///< SHA-256 of the secret seed, as 64 hexadecimal digits
  ExternalLimits limits;  ///< the same for all entries
};

/// Either a season, or the problems of its file.
struct SeasonResult {
  Season season;
  std::vector<Problem> problems;
};

/// Reads a season file of at most 64 KiB.
SeasonResult read_season(std::string_view text);

/// The text of a file with the secret seed, which secret_in() reads.
std::string secret_text(const std::string& secret);

/// The text of a season file, which read_season() reads.
std::string season_text(const Season& season);

/// Why no season can be held in that world; empty where it can.
std::string refuse_for_league(const World& world);

}  // namespace labmouse
