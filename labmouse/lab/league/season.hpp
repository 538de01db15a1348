// Season files: the world, mazes and limits of a league. docs/reference/files.md describes them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/external/limits.hpp"
#include "labmouse/lab/mazes/secret_mazes.hpp"
#include "labmouse/lab/worlds/world_table.hpp"

namespace labmouse {

/// A season file, as written.
struct Season {
  std::string title;
  std::string version;  ///< of labmouse, which wrote the file
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
