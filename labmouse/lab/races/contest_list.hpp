// What races of all worlds have in common: who races where, and how contests are held side by side.
#pragma once

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/system/parallel.hpp"

namespace labmouse {

/// The seed of a contest: from the race's seed, the maze's name without its folders, and the number of the run.
std::uint64_t contest_seed(std::uint64_t seed, std::string_view maze_name, int run);

/// A race of these mice on these mazes, both in the order of their names, before any contest.
template <class Race, class Mouse, class Order>
Race race_of(std::vector<Mouse>&& mice, std::vector<NamedMaze>&& mazes, const Order& order) {
  Race race;
  race.order = order;
  race.mice = std::move(mice);
  race.mazes = std::move(mazes);
  const auto by_name = [](const auto& a, const auto& b) { return a.name < b.name; };
  std::sort(race.mice.begin(), race.mice.end(), by_name);
  std::sort(race.mazes.begin(), race.mazes.end(), by_name);
  return race;
}

/// Lists the contests of a race by mouse, maze and run; runs_of(mouse) says how many one has in each maze.
template <class Race, class RunsOf>
void list_contests(Race& race, RunsOf runs_of) {
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse)
    for (std::size_t maze = 0; maze < race.mazes.size(); ++maze)
      for (int run = 0, runs = runs_of(race.mice[mouse]); run < runs; ++run) {
        auto& contest = race.results.emplace_back();
        contest.mouse = mouse;
        contest.maze = maze;
        contest.run = run;
        contest.seed = contest_seed(race.order.seed, race.mazes[maze].name, run);
      }
}

/// Holds all contests that are listed: hold(result) returns the record of one, and says in `result.done` whether it
/// came to its end. The hooks are asked before each, and told after each.
template <class Race, class Hooks, class Hold>
void hold_contests(Race& race, const Hooks& hooks, Hold hold) {
  std::mutex telling;
  for_each_parallel(race.results.size(), race.order.jobs, [&](std::size_t i) {
    if (hooks.stop != nullptr && hooks.stop->load()) return;
    auto& result = race.results[i];
    const auto record = hold(result);
    if (!hooks.finished || !result.done) return;
    const std::lock_guard lock(telling);
    hooks.finished(race, result, record);
  });
  race.stopped = std::any_of(race.results.begin(), race.results.end(), [](const auto& result) { return !result.done; });
}

}  // namespace labmouse
