#include "race_seconds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "labmouse/lab/galleries/drive_folder.hpp"
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "labmouse/lab/standings/drive_report.hpp"
#include "labmouse/lab/standings/drive_standings.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse::cli {
namespace {

std::vector<Contestant> find_drivers(const SecondsRace& options) {
  if (options.mice.empty()) return all_drivers();
  std::vector<Contestant> mice = find_contestants(options.mice);
  if (const std::string refusal = refuse_to_drive(mice); !refusal.empty()) throw UsageError("error: " + refusal);
  return mice;
}

/// The mazes that are not too large; of folders the others are skipped, as files are that hold no maze.
MazeCollection find_small_mazes(const SecondsRace& options) {
  const std::vector<std::string>& paths = options.contests.mazes;
  MazeCollection mazes = find_mazes(paths, options.contests.places);
  std::vector<SkippedFile> large;
  std::erase_if(mazes.mazes, [&](const NamedMaze& maze) {
    const Size size = maze.maze.size();
    if (size.width <= max_drive_side && size.height <= max_drive_side) return false;
    const std::string reason = fmt::format("is {}x{}; the world of seconds takes mazes up to {}x{}", size.width,
                                           size.height, max_drive_side, max_drive_side);
    if (std::find(paths.begin(), paths.end(), maze.name) != paths.end())
      throw UsageError(fmt::format("{}: error: {}", maze.name, reason));
    large.push_back({maze.name, {{no_place, no_place, reason}}});
    return true;
  });
  tell_skipped(large);
  mazes.skipped.insert(mazes.skipped.end(), large.begin(), large.end());
  if (mazes.mazes.empty()) throw UsageError("error: no maze to race on: all are too large for the world of seconds");
  return mazes;
}

DriveRaceOrder order_of(const SecondsRace& options) {
  DriveRaceOrder order;
  order.rules = find_rules_or_refuse(options.rules);
  order.model = std::make_shared<DriveModel>(find_robot_or_refuse(options.robot).model);
  order.runs = options.contests.order.runs;
  order.seed = options.contests.order.seed;
  order.jobs = options.contests.order.jobs;
  return order;
}

/// Holds the race and saves its contests in the folder of --out, which it takes. What went wrong with that is in
/// `failed_write`, and ends the race early.
DriveRace hold(const SecondsRace& options, std::vector<NamedMaze> mazes, std::unique_ptr<ResultsFolder>& taken,
               std::string& failed_write) {
  std::vector<Contestant> mice = find_drivers(options);
  const DriveRaceOrder order = order_of(options);
  taken = take_folder(options.out, options.overwrite);
  const std::size_t all = drive_contests_of(mice, mazes.size(), order);
  Progress progress;
  Interruptible interruptible;
  std::optional<DriveRaceFolder> folder;
  DriveRaceHooks hooks;
  hooks.stop = &interruptible.stopped();
  hooks.finished = [&](const DriveRace& race, const DriveResult& result, const DriveRecord& record) {
    progress.advance(all);
    if (options.out.empty() || !failed_write.empty()) return;
    if (!folder) folder.emplace(options.out, race);
    failed_write = folder->save(race, result, record);
    if (!failed_write.empty()) interruptible.stop();
  };
  return hold_drive_race(std::move(mice), std::move(mazes), order, hooks);
}

std::string save_results(const SecondsRace& options, const std::string& json) {
  if (options.out.empty()) return "";
  const std::string path = fmt::format("{}/{}", options.out, results_file_name);
  const std::string error = write_file(path, json);
  return error.empty() ? "" : fmt::format("{}: error: {}", path, error);
}

/// The mice whose mean is above the limit, or that did not score everywhere.
std::string above_limit(const DriveRace& race, double limit) {
  std::string text;
  for (const DriveStanding& standing : drive_standings_of(race)) {
    const std::string name = shown(race.mice[standing.mouse].name);
    if (standing.scored < standing.runs)
      text +=
          fmt::format("{} has no score in {} of {} contests\n", name, standing.runs - standing.scored, standing.runs);
    else if (standing.mean_score && *standing.mean_score > limit)
      text += fmt::format("{} scores {:.3f}, above the limit of {:g}\n", name, *standing.mean_score, limit);
  }
  return text;
}

}  // namespace

int race_in_seconds(const SecondsRace& options) {
  MazeCollection mazes = find_small_mazes(options);
  std::string failed_write;
  std::unique_ptr<ResultsFolder> taken;
  const DriveRace race = hold(options, std::move(mazes.mazes), taken, failed_write);
  const std::string json = json_of(race, mazes.skipped);
  if (failed_write.empty()) failed_write = save_results(options, json);
  taken.reset();
  print(options.format == "json" ? json : options.format == "csv" ? csv_of(race) : table_of(race, colours()));
  if (!failed_write.empty()) throw UsageError(failed_write);
  if (race.stopped) return exit_interrupted();
  const std::string above = options.fail_above ? above_limit(race, *options.fail_above) : "";
  tell(above);
  return above.empty() ? exit_good : exit_finding;
}

}  // namespace labmouse::cli
