#include "labmouse/lab/drives/known_drives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "labmouse/chance/rng.hpp"
#include "labmouse/lab/numbers/maze_interval.hpp"
#include "labmouse/lab/system/parallel.hpp"

namespace labmouse {
namespace {

void add(DriveTally& tally, const KnownDrive& drive) {
  ++tally.runs;
  tally.crashed += drive.crashed ? 1 : 0;
  tally.cells += drive.cells;
  tally.ticks += drive.ticks;
  tally.grazes += drive.grazes;
  tally.truth += drive.truth;
  tally.estimate += drive.estimate;
  tally.side += drive.side;
  tally.front += drive.front;
  if (!drive.crashed) tally.most_aside.push_back(drive.most_aside);
}

/// The drives of one maze in one case.
struct MazeDrives {
  std::vector<KnownDrive> drives;
  bool stopped = false;
};

MazeDrives drives_in(const DriveOrder& order, const NamedMaze& maze, const DriveCase& each,
                     const std::atomic<bool>* stop, const std::function<void()>& finished) {
  MazeDrives here;
  bool has_way = true;
  for (int run = 0; run < order.runs; ++run) {
    here.stopped = stop != nullptr && stop->load();
    if (here.stopped) return here;
    const std::uint64_t seed = seed_for(order.seed, maze.name, static_cast<std::uint64_t>(run));
    if (has_way) {
      const auto drive = drive_known_way(maze.maze, *order.model, each.conditions, order.way, seed, order.log);
      if (drive) here.drives.push_back(*drive);
      has_way = drive.has_value();
    }
    finished();
  }
  return here;
}

}  // namespace

std::vector<DriveTally> drive_known_ways(const DriveOrder& order, std::span<const NamedMaze> mazes,
                                         std::span<const DriveCase> cases, const DriveHooks& hooks) {
  std::vector<MazeDrives> drives(cases.size() * mazes.size());
  const std::size_t all = drives.size() * static_cast<std::size_t>(order.runs);
  std::mutex telling;
  const auto finished = [&] {
    const std::lock_guard lock(telling);
    if (hooks.finished) hooks.finished(all);
  };
  for_each_parallel(drives.size(), order.jobs, [&](std::size_t i) {
    drives[i] = drives_in(order, mazes[i % mazes.size()], cases[i / mazes.size()], hooks.stop, finished);
  });
  std::vector<DriveTally> tallies;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    DriveTally& tally = tallies.emplace_back();
    tally.name = cases[c].name;
    std::vector<MazeSum> crashes;
    for (std::size_t m = 0; m < mazes.size(); ++m) {
      const auto& [here, stopped] = drives[c * mazes.size() + m];
      tally.stopped = tally.stopped || stopped;
      if (here.empty()) continue;
      ++tally.mazes;
      const auto crashed =
          std::count_if(here.begin(), here.end(), [](const KnownDrive& drive) { return drive.crashed; });
      const double share = static_cast<double>(crashed) / static_cast<double>(here.size());
      crashes.push_back({static_cast<double>(crashed), static_cast<double>(here.size())});
      if (crashed == 0) ++tally.mazes_without_crash;
      if (share > tally.worst_share) {
        tally.worst_share = share;
        tally.worst_maze = mazes[m].name;
      }
      for (const KnownDrive& drive : here) add(tally, drive);
    }
    tally.interval = share_interval(crashes);
    std::sort(tally.most_aside.begin(), tally.most_aside.end());
  }
  return tallies;
}

bool is_stopped(std::span<const DriveTally> tallies) {
  return std::any_of(tallies.begin(), tallies.end(), [](const DriveTally& tally) { return tally.stopped; });
}

std::vector<DriveCase> cases_by_cause(const PhysicalConditions& conditions) {
  std::vector<DriveCase> cases = {{"all", conditions}};
  for (std::size_t cause = 0; cause < error_causes; ++cause) {
    DriveCase& alone = cases.emplace_back(DriveCase{std::string(name_of(static_cast<ErrorCause>(cause))), conditions});
    alone.conditions.errors.causes.fill(0.0);
    alone.conditions.errors.causes[cause] = conditions.errors.causes[cause];
  }
  return cases;
}

std::vector<DriveCase> cases_by_correction(const PhysicalConditions& conditions) {
  std::vector<DriveCase> cases;
  const auto add_case = [&](const char* name, const CorrectionChoice& choice) {
    cases.push_back({name, conditions});
    cases.back().conditions.controller.corrections = choice;
  };
  add_case("all", {});
  add_case("sides", {.edges = false, .front = false});
  add_case("edges, front", {.sides = false});
  add_case("none", {.sides = false, .edges = false, .front = false});
  return cases;
}

}  // namespace labmouse
