// Runs one contest in any world, and returns its play and record.
#include <fmt/format.h>

#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/mouse_spec.hpp"
#include "labmouse/lab/page/page_world.hpp"
#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/worlds/worlds.hpp"

namespace labmouse {
namespace {

/// The world of the request: by its settings, or by `conditions` as in the results of a race.
std::shared_ptr<const World> asked_world(PageRequest& request, const NamedMaze& maze) {
  if (!request.has("conditions")) {
    Entry entry = read_page_world(request);
    if (entry.world != nullptr) suit_defaults(entry, {&maze, 1});
    return entry.world;
  }
  auto world = restore_world(request.text("world"), request.json()["conditions"].dump());
  if (world == nullptr) request.reject("the page cannot hold contests under these conditions");
  return world;
}

}  // namespace

PageReply answer_contest(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  NamedMaze maze = request.maze();
  const std::shared_ptr<const World> world = asked_world(request, maze);
  const std::string spec = request.text("mouse");
  const std::uint64_t seed = request.seed();
  if (!request.error().empty()) return failed(request.error());
  SpecResult mice = read_page_mice({&spec, 1});
  if (!mice.error.empty()) return failed(mice.error);
  if (mice.contestants.size() != 1) return failed(fmt::format("'{}' names several mice; name exactly one", spec));
  if (std::string reason = world->refuse(mice.contestants.front()); !reason.empty()) return failed(std::move(reason));
  if (const std::string reason = world->refuse(maze.maze); !reason.empty())
    return failed(fmt::format("{} {}", maze.name, reason));
  Race race;
  race.order.world = world;
  race.facts.push_back(world->facts(maze.maze));
  race.mice = std::move(mice.contestants);
  race.mazes.push_back(std::move(maze));
  ContestResult result;
  result.seed = seed;
  ContestOutput held = world->hold(race, result, {.record = true, .reasons = true}, nullptr);
  const OpenedRecord opened = find_world(world->traits().name)->records->open(held.record, nullptr);
  if (!opened.replay)
    return failed(fmt::format("the page plays no single contests in the world {}", world->traits().name));
  Json play = opened.replay->play();
  play["again"] = again_json(*world);
  return answered({{"play", std::move(play)}, {"record", std::move(held.record)}});
}

}  // namespace labmouse
