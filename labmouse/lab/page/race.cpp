// Runs a race.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/external.hpp"
#include "labmouse/lab/page/mouse_spec.hpp"
#include "labmouse/lab/page/page_world.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/worlds/entering.hpp"

namespace labmouse {
namespace {

/// Limits, because the module has one thread and answers nothing else meanwhile.
constexpr std::size_t most_contests = 20'000;
constexpr int most_runs = 1'000;

std::vector<Contestant> read_mice(PageRequest& request, const World* world) {
  const ReadJson& list = request.list("mice");
  if (world == nullptr || (list.empty() && request.has("played"))) return {};
  if (list.empty()) return residents_of(*world);
  std::vector<std::string> specs;
  for (const ReadJson& spec : list)
    if (spec.is_string())
      specs.push_back(spec.get<std::string>());
    else
      request.reject("'mice' has an entry that is not a string");
  SpecResult result = read_page_mice(specs);
  request.reject(result.error);
  for (const Contestant& mouse : result.contestants) request.reject(world->refuse(mouse));
  return std::move(result.contestants);
}

std::vector<NamedMaze> read_mazes(PageRequest& request, const World* world) {
  std::vector<NamedMaze> mazes;
  for (const ReadJson& each : request.list("mazes")) {
    mazes.push_back(request.maze_at(each, fmt::format("mazes[{}]", mazes.size())));
    const auto same = [&](const NamedMaze& maze) { return maze.name == mazes.back().name; };
    if (std::count_if(mazes.begin(), mazes.end(), same) > 1)
      request.reject(fmt::format("two mazes are named '{}'", mazes.back().name));
    if (const std::string reason = world != nullptr ? world->refuse(mazes.back().maze) : ""; !reason.empty())
      request.reject(fmt::format("{} {}", mazes.back().name, reason));
    if (!request.error().empty()) break;
  }
  if (mazes.empty()) request.reject("a race needs at least one maze");
  return mazes;
}

}  // namespace

PageReply answer_race(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  Entry entry = read_page_world(request);
  std::vector<Contestant> mice = read_mice(request, entry.world.get());
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
