// A season as files for a web server.
#pragma once

#include <optional>
#include <string>

#include "labmouse/lab/league/season_races.hpp"

namespace labmouse {

/// The results of a season. Equal contests make equal files, on every computer and with any number of threads.
struct SeasonResults {
  const League& league;
  const SeasonRaces& races;
  Ranking ranking;
  /// The seed of the examination, once it may be known.
  std::optional<std::string> revealed;
};

/// Ranks the mice. No contest may be missing.
SeasonResults results_of(const League& league, const SeasonRaces& races, std::optional<std::string> revealed = {});

/// The ranking as a table for a terminal.
std::string table_of(const SeasonResults& results);

/// What programs could do to the computer, and what the sandbox cannot promise, in lines.
std::string promises_of(const SeasonResults& results);

/// The whole season as JSON.
std::string json_of(const SeasonResults& results);

/// The page of the season: HTML that needs no script and no other file.
std::string index_page(const SeasonResults& results);

}  // namespace labmouse
