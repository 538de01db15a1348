#include "labmouse/lab/races/drive_race.hpp"

#include "labmouse/contest/drive.hpp"
#include "labmouse/lab/races/contest_list.hpp"

namespace labmouse {
namespace {

int runs_of(const Contestant& mouse, const DriveRaceOrder& order) { return mouse.uses_chance ? order.runs : 1; }

/// The fastest of the runs that count.
std::optional<MazeTime> best_of(const DriveScore& score) {
  std::optional<MazeTime> best;
  for (const DriveRunScore& run : score.runs)
    if (run.rest_to_centre && (!best || *run.rest_to_centre < *best)) best = run.rest_to_centre;
  return best;
}

void sum_up(const DriveRecord& record, DriveResult& result) {
  bool driven = false;
  for (const DriveRun& run : record.runs) {
    const bool fast = run.kind == DriveRun::Kind::fast;
    if (!driven) result.search = fast ? run.begin : run.end;
    driven = driven || fast;
    if (fast) result.proven = run.known == run.hoped;
    if (run.kind != DriveRun::Kind::home) ++result.starts;
  }
  result.best = best_of(result.score);
  result.reason = record.reason;
  result.decisions = record.decisions;
  result.replanned = record.replanned;
}

DriveRecord hold_contest(const DriveRace& race, DriveResult& result) {
  const Maze& maze = race.mazes[result.maze].maze;
  const DriveModel& model = *race.order.model;
  const auto mouse = race.mice[result.mouse].drive(brief(maze, race.order.rules, model, result.seed));
  DriveRecord record = drive(maze, race.order.rules, model, *mouse);
  result.score = score(record, race.order.rules);
  sum_up(record, result);
  result.done = true;
  return record;
}

}  // namespace

std::size_t drive_contests_of(const std::vector<Contestant>& mice, std::size_t mazes, const DriveRaceOrder& order) {
  std::size_t all = 0;
  for (const Contestant& mouse : mice) all += mazes * static_cast<std::size_t>(runs_of(mouse, order));
  return all;
}

std::vector<Contestant> all_drivers() {
  std::vector<Contestant> mice = all_contestants();
  std::erase_if(mice, [](const Contestant& mouse) { return !mouse.drive; });
  return mice;
}

DriveRecordFile drive_record_file_of(const DriveRace& race, const DriveResult& result, const DriveRecord& record) {
  DriveRecordFile file;
  file.maze_name = race.mazes[result.maze].name;
  file.maze = race.mazes[result.maze].maze;
  file.mouse = race.mice[result.mouse].name;
  file.settings = settings_in_seconds(race.mice[result.mouse]);
  file.seed = result.seed;
  file.model = race.order.model;
  file.tables_hash = race.order.model->tables.hash;
  file.rules = race.order.rules;
  file.record = record;
  if (const auto& best = result.score.best) file.recorded_score = result.score.runs[*best];
  return file;
}

DriveRace hold_drive_race(std::vector<Contestant> mice, std::vector<NamedMaze> mazes, const DriveRaceOrder& order,
                          const DriveRaceHooks& hooks) {
  auto race = race_of<DriveRace>(std::move(mice), std::move(mazes), order);
  race.bounds.resize(race.mazes.size());
  for_each_parallel(race.mazes.size(), order.jobs, [&](std::size_t i) {
    race.bounds[i] = drive_bound_of(race.mazes[i].maze, order.rules, *order.model);
  });
  list_contests(race, [&](const Contestant& mouse) { return runs_of(mouse, order); });
  hold_contests(race, hooks, [&](DriveResult& result) { return hold_contest(race, result); });
  return race;
}

}  // namespace labmouse
