#include <algorithm>
#include <mutex>

#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/lab/failure_rates/failure_rates.hpp"
#include "labmouse/lab/mice/stoppable.hpp"
#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/system/parallel.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {
namespace {

struct MeasuredPart {
  FailureTally tally;
  bool stopped = false;
};

/// Ticks between two points of the trace: a mouse goes a few millimetres in that time.
constexpr int ticks_a_point = 5;

/// The contests of one mouse in one maze under the variation and at the pace of that tally.
MeasuredPart part_of(const FailureOrder& order, const FailureTally& tally, const Contestant& mouse,
                     const NamedMaze& maze, const std::atomic<bool>* stop, const std::function<void()>& finished) {
  const double pace = tally.pace;
  MeasuredPart part = {{tally.variation, pace, {}}};
  PhysicalConditions conditions = order.conditions;
  conditions.errors.variation = tally.variation;
  conditions.controller.pace = pace;
  conditions.trace_every = ticks_a_point;
  for (int run = 0; run < order.runs; ++run) {
    part.stopped = stop != nullptr && stop->load();
    if (part.stopped) return part;
    const std::uint64_t seed = contest_seed(order.seed, maze.name, run);
    Briefing briefing = brief(maze.maze, order.rules, *order.model, seed);
    briefing.sight = 1;
    briefing.drive.pace = pace;
    const auto strategy = mouse.driving_strategy(maze.maze, briefing);
    StoppableDriver stoppable(*strategy, stop);
    const PhysicalRecord record = drive_physically(maze.maze, order.rules, *order.model, conditions, seed, stoppable);
    part.stopped = record.drive.reason == ForfeitReason::interrupted;
    if (part.stopped) return part;
    const RobotSample sample(*order.model->robot.hardware, conditions.errors, maze.maze.size(), seed);
    count_failures(record, maze.maze, order.model->tables.cell, sample, part.tally);
    finished();
  }
  return part;
}

std::vector<double> sorted(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

}  // namespace

MeasuredRates measure_rates(const FailureOrder& ordered, std::span<const Contestant> mice,
                            std::span<const NamedMaze> mazes, const FailureHooks& hooks) {
  FailureOrder order = ordered;
  DriveModel model = *order.model;
  share_route_tables(model);
  order.model = std::make_shared<const DriveModel>(std::move(model));
  MeasuredRates measured;
  std::vector<FailureTally>& tallies = measured.tallies;
  for (const double pace : sorted(order.paces))
    for (const double variation : sorted(order.variations)) tallies.push_back({variation, pace, {}});
  for (const FailureTally& tally : tallies)
    measured.by_maze.emplace_back(mazes.size(), FailureTally{tally.variation, tally.pace, {}});
  const std::size_t pairs = mice.size() * mazes.size();
  std::vector<MeasuredPart> parts(tallies.size() * pairs);
  const std::size_t all = parts.size() * static_cast<std::size_t>(order.runs);
  std::mutex telling;
  const auto finished = [&] {
    const std::lock_guard lock(telling);
    if (hooks.finished) hooks.finished(all);
  };
  for_each_parallel(parts.size(), order.jobs, [&](std::size_t i) {
    const std::size_t pair = i % pairs;
    parts[i] =
        part_of(order, tallies[i / pairs], mice[pair % mice.size()], mazes[pair / mice.size()], hooks.stop, finished);
  });
  for (std::size_t i = 0; i < parts.size(); ++i) {
    tallies[i / pairs] += parts[i].tally;
    measured.by_maze[i / pairs][i % pairs / mice.size()] += parts[i].tally;
    measured.stopped = measured.stopped || parts[i].stopped;
  }
  return measured;
}

}  // namespace labmouse
