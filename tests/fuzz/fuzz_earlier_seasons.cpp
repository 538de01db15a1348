// Any bytes as the results of an earlier season: there are seasons that are read again as they were written, or there
// is an error.
#include "labmouse/functions/sha256.hpp"
#include "labmouse/lab/league/earlier_seasons.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

LABMOUSE_FUZZER(earlier_seasons) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const EarlierSeasonsResult read = read_earlier_seasons(text);
  require(read.seasons.empty() != read.error.empty());
  require(shown(read.error) == read.error);
  for (const EarlierSeason& season : read.seasons) {
    require(!season.title.empty() && shown(season.title) == season.title && is_sha256_text(season.seed_hash));
    for (const EarlierMouse& mouse : season.mice) {
      require(!mouse.name.empty() && mouse.rank >= 1 && mouse.share >= 0.0 && mouse.share <= 1.0);
      require(mouse.interval.low >= 0.0 && mouse.interval.high <= 1.0);
    }
  }
  if (read.seasons.empty()) return 0;
  Json next = {{"labmouse", "league"},
               {"format", 1},
               {"season",
                {{"title", "next"},
                 {"world", "steps"},
                 {"examination_mazes", 1},
                 {"examination_seed_sha256", sha256_text("seed")},
                 {"examination_seed", "seed"}}},
               {"mice", Json::array()},
               {"earlier_seasons", json_of(read.seasons)}};
  const EarlierSeasonsResult again = read_earlier_seasons(next.dump());
  require(again.seasons.size() == read.seasons.size() + 1);
  return 0;
}

}  // namespace labmouse::fuzz
