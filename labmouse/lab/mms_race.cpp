#include "labmouse/lab/mms_race.hpp"

#include <algorithm>
#include <mutex>

#include "labmouse/lab/mms_record.hpp"
#include "labmouse/lab/parallel.hpp"

namespace labmouse {
namespace {

std::vector<MmsResult> list_runs(const MmsRace& race) {
  std::vector<MmsResult> results;
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse)
    for (std::size_t maze = 0; maze < race.mazes.size(); ++maze) results.push_back({mouse, maze, false, {}});
  return results;
}

/// Whether a line says something: blanks do not, nor do the marks that Python puts below the words of a traceback.
bool says_something(std::string_view line) { return line.find_first_not_of(" \t\r^~") != std::string_view::npos; }

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
  MmsRace race;
  race.order = order;
  race.mice = std::move(mice);
  race.mazes = std::move(mazes);
  const auto by_name = [](const auto& a, const auto& b) { return a.name < b.name; };
  std::sort(race.mice.begin(), race.mice.end(), by_name);
  std::sort(race.mazes.begin(), race.mazes.end(), by_name);
  race.results = list_runs(race);
  race.bounds.resize(race.mazes.size());
  for_each_parallel(race.mazes.size(), order.jobs,
                    [&](std::size_t i) { race.bounds[i] = mms_bound_of(race.mazes[i].maze); });

  std::mutex telling;
  for_each_parallel(race.results.size(), order.jobs, [&](std::size_t i) {
    if (hooks.stop != nullptr && hooks.stop->load()) return;
    const std::string record = hold_run(race, race.results[i], hooks.stop);
    if (!hooks.finished || !race.results[i].done) return;
    const std::lock_guard lock(telling);
    hooks.finished(race, race.results[i], record);
  });
  race.stopped = std::any_of(race.results.begin(), race.results.end(), [](const MmsResult& r) { return !r.done; });
  return race;
}

std::vector<std::string> last_lines(std::string_view errors, std::size_t most) {
  std::vector<std::string> lines;
  while (!errors.empty() && lines.size() < most) {
    const auto end = errors.rfind('\n');
    const std::string_view line = end == std::string_view::npos ? errors : errors.substr(end + 1);
    if (says_something(line)) lines.emplace_back(line.substr(0, kept_text));
    errors = end == std::string_view::npos ? std::string_view() : errors.substr(0, end);
  }
  std::reverse(lines.begin(), lines.end());
  return lines;
}

}  // namespace labmouse
