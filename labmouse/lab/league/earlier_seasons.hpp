// Seasons that are over: how their mice did, read from the results that were published.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/numbers/interval.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// A mouse in a season that is over.
struct EarlierMouse {
  std::string name;
  int rank = 1;
  double share = 0.0;  ///< mean share of the best possible score, 0 to 1
  Interval interval;
  std::string hash;  ///< SHA-256 of its files; empty for a built-in mouse
};

struct EarlierSeason {
  std::string title, world;
  int mazes = 1;                   ///< of the examination
  std::string seed_hash;           ///< SHA-256 of the seed, as 64 hexadecimal digits
  std::vector<EarlierMouse> mice;  ///< best first
};

/// Seasons, the oldest first; or why there are none.
struct EarlierSeasonsResult {
  std::vector<EarlierSeason> seasons;
  std::string error;  ///< such as "line 3, column 1: ...", or "'season.title' is missing"; empty on success
};

inline constexpr std::size_t most_results_bytes = std::size_t{64} << 20U;

/// Reads the `results.json` of a season that is over: the seasons before it, and itself. It refuses one whose seed is
/// not published.
EarlierSeasonsResult read_earlier_seasons(std::string_view text);

/// As `results.json` of the next season has them.
Json json_of(const std::vector<EarlierSeason>& seasons);

}  // namespace labmouse
