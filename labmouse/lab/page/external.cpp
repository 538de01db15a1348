#include "labmouse/lab/page/external.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "labmouse/lab/mice/named_spec.hpp"
#include "labmouse/lab/records/record_file.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

constexpr std::size_t longest_name = 40;

/// Why a mouse cannot have this name; empty if it can.
std::string refuse_name(const std::string& name) {
  if (name.size() > longest_name) return fmt::format("the name of a mouse has at most {} letters", longest_name);
  if (shown(name) != name) return fmt::format("the name '{}' contains unprintable characters", shown(name));
  if (const auto sign = name.find_first_of("=:,/ "); sign != std::string::npos)
    return fmt::format("the name '{}' contains {}; write it without", name,
                       name[sign] == ' ' ? "a blank" : fmt::format("a '{}'", name[sign]));
  if (find_mouse(name) != nullptr || name == "oracle")
    return fmt::format("'{}' is the name of another mouse; choose one of your own", name);
  return "";
}

/// Reads one contest of `played`; its record must be of that mouse and of this race.
void read_contest(PageRequest& request, const ReadJson& json, const Contestant& mouse, const RaceOrder& order,
                  PlayedContests& contests) {
  PageRequest fields(json);
  PlayedContest contest;
  contest.microseconds = fields.not_negative("microseconds");
  contest.started = fields.flag("started");
  const std::string text = fields.text("record");
  request.reject(fields.error());
  if (!request.error().empty()) return;
  ReadRecordResult read = read_record(text);
  if (!read.file || !read.file->maze) return request.reject(fmt::format("a record of {} is not readable", mouse.name));
  ReplayResult replayed = replay(*read.file, *read.file->maze);
  if (!replayed.disagreement.empty())
    return request.reject(fmt::format("a record of {} does not match its maze", mouse.name));
  if (read.file->mouse != mouse.name || read.file->rules != order.world->traits().rules_in_steps)
    return request.reject(fmt::format("a record of {} is not of this race", mouse.name));
  contest.record = std::move(replayed.run);
  contests[{read.file->maze_name, read.file->seed}] = std::move(contest);
}

Contestant read_mouse(PageRequest& request, const ReadJson& json, const std::vector<NamedMaze>& mazes,
                      const RaceOrder& order) {
  PageRequest fields(json);
  Contestant mouse = read_page_external(fields);
  const ReadJson& list = fields.list("contests");
  request.reject(fields.error());
  PlayedContests contests;
  for (const ReadJson& contest : list) {
    if (!request.error().empty()) return mouse;
    read_contest(request, contest, mouse, order, contests);
  }
  for (const NamedMaze& maze : mazes)
    if (!contests.contains({maze.name, seed_of_program(order.seed, 0)}))
      request.reject(fmt::format("{} has held no contest in {}", mouse.name, maze.name));
  mouse.kind = std::move(contests);
  return mouse;
}

}  // namespace

Contestant read_page_external(PageRequest& request) {
  Contestant mouse;
  mouse.runs = 1;
  mouse.external = true;
  const std::string name = request.text("name"), spec = request.text("spec");
  if (shown(spec) != spec || spec.empty()) request.reject("'spec' is none");
  request.reject(refuse_name(name));
  mouse.name = spec;
  if (!name.empty()) rename(mouse, name);
  return mouse;
}

std::vector<Contestant> read_played_mice(PageRequest& request, const std::vector<NamedMaze>& mazes,
                                         const RaceOrder& order) {
  std::vector<Contestant> mice;
  if (!request.has("played")) return mice;
  for (const ReadJson& each : request.list("played")) {
    if (!request.error().empty()) break;
    if (!order.world->traits().rules_in_steps)
      request.reject(fmt::format("your own mice race in steps only, not in the world {}", order.world->traits().name));
    mice.push_back(read_mouse(request, each, mazes, order));
    const auto same = [&](const Contestant& mouse) { return mouse.name == mice.back().name; };
    if (std::count_if(mice.begin(), mice.end(), same) > 1)
      request.reject(fmt::format("two mice are named '{}'", mice.back().name));
  }
  return mice;
}

}  // namespace labmouse
