// Runs a race.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/entrants.hpp"
#include "labmouse/lab/page/external.hpp"
#include "labmouse/lab/page/page_world.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/worlds/entering.hpp"

namespace labmouse {
namespace {

/// Limits, because the module has one thread and answers nothing else meanwhile.
constexpr std::size_t most_contests = 20'000;
constexpr int most_runs = 1'000;

}  // namespace

PageReply answer_race(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  Entry entry = read_page_world(request);
  // A race of the user's mouse alone has no others.
  const bool is_alone = request.has("played") && request.list("mice").empty();
  std::vector<Contestant> mice = is_alone ? std::vector<Contestant>() : read_mice(request, entry.world.get());
  std::vector<NamedMaze> mazes = read_mazes(request, entry.world.get());
  if (entry.world != nullptr) suit_defaults(entry, mazes);
  RaceOrder order;
  order.world = entry.world;
  order.runs = request.whole("runs", 1, most_runs);
  order.seed = request.seed();
  if (!request.error().empty()) return failed(request.error());
  std::vector<Contestant> played = read_played_mice(request, mazes, order);
  if (!request.error().empty()) return failed(request.error());
  std::move(played.begin(), played.end(), std::back_inserter(mice));
  if (const auto contests = contests_of(mice, mazes.size(), order); contests > most_contests)
    return failed(fmt::format("{} contests are too many for the page, whose limit is {}; use `labmouse race`", contests,
                              most_contests));
  const Race race = hold_race(std::move(mice), std::move(mazes), order);
  return answered({{"results", race_json({&race, 1}, {})}});
}

}  // namespace labmouse
