// Any bytes as a season file: there is a season that is read again as it was written, or there are problems.
#include "labmouse/functions/sha256.hpp"
#include "labmouse/lab/league/season.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

LABMOUSE_FUZZER(season) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const SeasonResult read = read_season(text);
  require(read.problems.size() <= most_problems);
  if (!read.problems.empty()) return 0;
  const Season& season = read.season;
  require(season.world.entry != nullptr && is_sha256_text(season.seed_hash));
  require(refuse(season.examination).empty());
  require(season.limits.start.count() > 0 && season.limits.processes > 0 && season.limits.memory > 0);
  const std::string written = season_text(season);
  const SeasonResult again = read_season(written);
  require(again.problems.empty() && season_text(again.season) == written);
  return 0;
}

}  // namespace labmouse::fuzz
