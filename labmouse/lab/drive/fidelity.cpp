#include "labmouse/lab/drive/fidelity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "labmouse/lab/drive/drive_worlds.hpp"
#include "labmouse/lab/numbers/maze_interval.hpp"
#include "labmouse/lab/text/errors_text.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// Contests of one maze.
struct MazeCount {
  int contests = 0, physical = 0, failures = 0;
};

Fidelity fidelity_of(const Race& physical, const Race& failures, std::size_t mouse, double variation) {
  Fidelity sum = {physical.mice[mouse].name, variation, 0, 0, 0, 0.0, std::nullopt};
  std::vector<MazeCount> by_maze(physical.mazes.size());
  for (std::size_t i = 0; i < physical.results.size(); ++i) {
    const ContestResult& one = physical.results[i];
    if (one.mouse != mouse || !counts(physical, one)) continue;
    MazeCount& count = by_maze[one.maze];
    ++count.contests;
    count.physical += one.score ? 1 : 0;
    count.failures += failures.results[i].score ? 1 : 0;
  }
  std::vector<MazeSum> differences;
  for (const MazeCount& count : by_maze) {
    if (count.contests == 0) continue;
    sum.contests += count.contests;
    sum.physical += count.physical;
    sum.failures += count.failures;
    differences.push_back({1.0 * (count.failures - count.physical), 1.0 * count.contests});
  }
  if (sum.contests > 0) sum.difference = 1.0 * (sum.failures - sum.physical) / sum.contests;
  if (differences.size() > 1) sum.interval = including(interval_of(differences, 1), sum.difference);
  return sum;
}

}  // namespace

std::vector<Fidelity> compare_worlds(const FailureOrder& order, const FailureFile& failure_rates,
                                     std::span<const Contestant> mice, std::span<const NamedMaze> mazes,
                                     const std::atomic<bool>* stop) {
  std::vector<Fidelity> all;
  RaceHooks hooks;
  hooks.stop = stop;
  for (const double variation : order.variations) {
    PhysicalConditions conditions = order.conditions;
    conditions.errors.noise = failure_rates.noise;
    conditions.errors.variation = variation;
    const auto race_in = [&](std::shared_ptr<const World> world) {
      RaceOrder race;
      race.world = std::move(world);
      race.runs = order.runs;
      race.seed = order.seed;
      race.jobs = order.jobs;
      return hold_race({mice.begin(), mice.end()}, {mazes.begin(), mazes.end()}, race, hooks);
    };
    const Race physical = race_in(physical_world(order.rules, order.model, conditions));
    const Race failures = race_in(failure_world(order.rules, order.model, conditions, failure_rates));
    if (physical.stopped || failures.stopped) return all;
    for (std::size_t mouse = 0; mouse < physical.mice.size(); ++mouse)
      all.push_back(fidelity_of(physical, failures, mouse, variation));
  }
  return all;
}

bool is_faithful(const Fidelity& fidelity, const FidelityBars& bars) {
  const bool near = std::abs(fidelity.difference) <= bars.difference;
  return near &&
         (!fidelity.interval || (fidelity.interval->low >= -bars.interval && fidelity.interval->high <= bars.interval));
}

std::string table_of(std::span<const Fidelity> all, const FidelityBars& bars) {
  std::size_t width = 5;
  for (const Fidelity& each : all) width = std::max(width, shown(each.mouse).size());
  std::string text = fmt::format("{:<{}} {:>15} {:>9} {:>10} {:>10} {:>11} {:>15}\n", "mouse", width, "variation",
                                 "contests", "physical %", "failures %", "difference", "95 %");
  for (const Fidelity& each : all) {
    const auto percent = [&](int finished) { return 100.0 * finished / std::max(1, each.contests); };
    text += fmt::format("{:<{}} {:>15} {:>9} {:>10.1f} {:>10.1f} {:>+11.1f} {:>15}{}\n", shown(each.mouse), width,
                        variation_text(each.variation), each.contests, percent(each.physical), percent(each.failures),
                        100.0 * each.difference,
                        each.interval
                            ? fmt::format("{:+.1f} to {:+.1f}", 100.0 * each.interval->low, 100.0 * each.interval->high)
                            : "-",
                        is_faithful(each, bars) ? "" : "  too far");
  }
  return text;
}

}  // namespace labmouse
