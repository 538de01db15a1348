#include "labmouse/lab/races/race.hpp"

#include <algorithm>
#include <mutex>
#include <set>

#include "labmouse/chance/rng.hpp"
#include "labmouse/lab/races/race_order.hpp"
#include "labmouse/lab/system/parallel.hpp"
#include "labmouse/mouse/action.hpp"

namespace labmouse {
namespace {

int runs_of(const Contestant& mouse, const RaceOrder& order) {
  if (!order.world->traits().numbers_runs) return 1;
  if (mouse.runs > 0) return mouse.runs;
  return mouse.uses_chance || order.world->traits().is_stochastic ? order.runs : 1;
}

bool is_stopped(const RaceHooks& hooks) { return hooks.stop != nullptr && hooks.stop->load(); }

/// Finds what the world knows of the mazes; false where it was stopped before it knew all.
bool find_facts(Race& race, const RaceHooks& hooks) {
  MazeFacts unknown;
  unknown.found = false;
  race.facts.resize(race.mazes.size(), unknown);
  for_each_parallel(race.mazes.size(), race.order.jobs, [&](std::size_t i) {
    if (!is_stopped(hooks)) race.facts[i] = race.world().facts(race.mazes[i].maze);
  });
  return std::all_of(race.facts.begin(), race.facts.end(), [](const MazeFacts& facts) { return facts.found; });
}

/// Assigns contests to the shards in turn, so that the contests of a slow mouse are spread over all shards.
void list_contests(Race& race) {
  std::size_t number = 0;
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse)
    for (std::size_t maze = 0; maze < race.mazes.size(); ++maze)
      for (int run = 0, runs = runs_of(race.mice[mouse], race.order); run < runs; ++run) {
        if (number++ % race.order.shard.of + 1 != race.order.shard.number) continue;
        ContestResult& contest = race.results.emplace_back();
        contest.mouse = mouse;
        contest.maze = maze;
        contest.run = run;
        contest.told = seed_of_program(race.order.first_told ? *race.order.first_told + maze : race.order.seed, run);
        // In a stochastic world the random draws differ between mazes.
        contest.seed = race.mice[mouse].external && !race.world().traits().is_stochastic
                           ? contest.told
                           : contest_seed(race.order.seed, race.mazes[maze].name, run);
      }
}

/// Hides the files that contain mazes from the external mice.
void hide_files(const Race& race) {
  std::set<HiddenFiles*> lists;
  for (const Contestant& mouse : race.mice)
    if (mouse.hidden) lists.insert(mouse.hidden.get());
  for (HiddenFiles* hidden : lists) {
    // The names of other mazes, such as generated ones, would only grow into a long list.
    for (const NamedMaze& maze : race.mazes) hidden->add_if_there(maze.name);
    for (const std::string& file : race.order.files) hidden->add_store(file);
  }
}

/// Takes from the store what it has. A contest whose record or picture is wanted runs all the same.
void recall(Race& race, const RaceHooks& hooks) {
  if (!race.order.store) return;
  race.order.store->recall(race, [&](const ContestResult& contest) {
    const Keep keep = hooks.keep ? hooks.keep(contest) : Keep();
    return !keep.record && !keep.picture;
  });
  if (!hooks.finished) return;
  for (const ContestResult& contest : race.results)
    if (contest.done) hooks.finished(race, contest, {});
}

}  // namespace

std::uint64_t contest_seed(std::uint64_t seed, std::string_view maze_name, int run) {
  // 53 bits: a JSON reader that keeps numbers as doubles gets them whole.
  return seed_for(seed, maze_name.substr(maze_name.rfind('/') + 1), static_cast<std::uint64_t>(run)) >> 11U;
}

std::uint64_t seed_of_program(std::uint64_t seed, int run) { return contest_seed(seed, "external mouse", run); }

void leave_unjudged(ContestResult& result) {
  result.judged = false;
  result.outcome = name_of(ForfeitReason::not_judged);
  result.never_started.clear();
  result.score.reset();
  result.counted.reset();
  result.ratio.reset();
}

std::size_t contests_of(const std::vector<Contestant>& mice, std::size_t mazes, const RaceOrder& order) {
  std::size_t all = 0;
  for (const Contestant& mouse : mice) all += mazes * static_cast<std::size_t>(runs_of(mouse, order));
  return (all + order.shard.of - order.shard.number) / order.shard.of;
}

Race hold_race(std::vector<Contestant> mice, std::vector<NamedMaze> mazes, const RaceOrder& order,
               const RaceHooks& hooks) {
  Race race;
  race.order = order;
  race.mice = std::move(mice);
  race.mazes = std::move(mazes);
  std::sort(race.mice.begin(), race.mice.end(), in_race_order);
  std::sort(race.mazes.begin(), race.mazes.end(), in_race_order);
  list_contests(race);
  hide_files(race);
  if (find_facts(race, hooks)) recall(race, hooks);
  std::mutex telling;
  for_each_parallel(race.results.size(), order.jobs, [&](std::size_t i) {
    if (is_stopped(hooks)) return;
    ContestResult& result = race.results[i];
    if (result.done || (order.store && order.store->failed())) return;
    const ContestOutput held = race.world().hold(race, result, hooks.keep ? hooks.keep(result) : Keep(), hooks.stop);
    if (result.done && result.judged && order.store) order.store->keep(race, result);
    if (!hooks.finished || !result.done) return;
    const std::lock_guard lock(telling);
    hooks.finished(race, result, held);
  });
  const auto is_done = [](const ContestResult& result) { return result.done; };
  race.stopped = !std::all_of(race.results.begin(), race.results.end(), is_done);
  race.order.store.reset();
  return race;
}

bool counts(const Race& race, const ContestResult& contest) {
  return contest.done && contest.judged && race.facts[contest.maze].bound.has_value();
}

ContestResult without_clock(ContestResult contest, const WorldFields& fields) {
  if (contest.figures == nullptr) return contest;
  std::vector<Value> values = fields.figures.values_of(*contest.figures);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (fields.figures.all[i].by_clock) values[i] = 0.0;
  contest.figures = fields.figures.figures_of(values);
  return contest;
}

Value figure_of(const Race& race, const ContestResult& contest, std::string_view key) {
  for (const ContestField& field : race.world().traits().fields->contest)
    if (field.key == key) return field.of(race, contest);
  return {};
}

}  // namespace labmouse
