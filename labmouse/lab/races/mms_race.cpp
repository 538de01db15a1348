#include "labmouse/lab/races/mms_race.hpp"

#include <algorithm>

#include "labmouse/lab/races/contest_list.hpp"
#include "labmouse/lab/records/mms_record.hpp"

namespace labmouse {
namespace {

std::vector<MmsResult> list_runs(const MmsRace& race) {
  std::vector<MmsResult> results;
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse)
    for (std::size_t maze = 0; maze < race.mazes.size(); ++maze) results.push_back({mouse, maze, false, {}});
  return results;
}

/// Takes away what a race does not keep of a run.
void trim(MmsRun& run) {
  run.canvas = {};
  run.log.resize(std::min(run.log.size(), kept_log));
  for (std::string& sentence : run.log) sentence.resize(std::min(sentence.size(), kept_text));
  run.log.shrink_to_fit();
  std::string errors;
  for (const std::string& line : last_lines(run.errors)) errors += line + '\n';
  run.errors = std::move(errors);
}

/// Hosts one run. Returns its record, where one was asked for.
std::string hold_run(const MmsRace& race, MmsResult& result, const std::atomic<bool>* stop) {
  const NamedMaze& maze = race.mazes[result.maze];
  const MmsMouse& mouse = race.mice[result.mouse];
  Launch launch = mouse.launch;
  launch.stop = stop;
  std::string record;
  if (race.order.records) {
    MmsRecorder recorder(mouse.name, maze);
    result.run = run_mms(launch, maze.maze, race.order.options,
                         [&](const MmsEvent& event, const MmsHost&) { recorder.add(event); });
    record = recorder.finish(result.run);
  } else {
    result.run = run_mms(launch, maze.maze, race.order.options);
  }
  result.done = result.run.outcome != MmsOutcome::interrupted;
  trim(result.run);
  return record;
}

}  // namespace

MmsRace hold_mms_race(std::vector<MmsMouse> mice, std::vector<NamedMaze> mazes, const MmsRaceOrder& order,
                      const MmsRaceHooks& hooks) {
  auto race = race_of<MmsRace>(std::move(mice), std::move(mazes), order);
  race.results = list_runs(race);
  race.bounds.resize(race.mazes.size());
  for_each_parallel(race.mazes.size(), order.jobs,
                    [&](std::size_t i) { race.bounds[i] = mms_bound_of(race.mazes[i].maze); });
  hold_contests(race, hooks, [&](MmsResult& result) { return hold_run(race, result, hooks.stop); });
  return race;
}

}  // namespace labmouse
