#include "labmouse/contest/drive_score.hpp"

#include <algorithm>

namespace labmouse {
namespace {

/// The times of a run to a goal, or of the fastest lap.
DriveRunScore times_of(const DriveRun& run, const DriveRules& rules) {
  DriveRunScore score;
  if (const auto lap = fastest_lap(run, rules.time_limit)) {
    score.gate_to_gate = lap->time;
    score.lap = lap->number;
  }
  if (run.gate_out && run.gate_in) score.gate_to_gate = *run.gate_in - *run.gate_out;
  if (run.centre) score.rest_to_centre = *run.centre - run.begin;
  return score;
}

/// Whether a run is of the kind that counts, and ended within the time limit.
bool counts(const DriveRun& run, const DriveRules& rules) {
  if (run.kind == DriveRun::Kind::home) return false;
  if (rules.counts == Counted::lap) return run.kind == DriveRun::Kind::laps;
  if (rules.counts == Counted::dead_end && !run.dead_ends) return false;
  const auto& end = rules.gate_to_gate ? run.gate_in : run.centre;
  return end && *end <= rules.time_limit;
}

/// Score of a run; nullopt if the run does not count by the rules.
std::optional<DriveRunScore> score_of(const DriveRun& run, const DriveRules& rules) {
  if (!counts(run, rules)) return std::nullopt;
  DriveRunScore score = times_of(run, rules);
  const auto& time = rules.gate_to_gate ? score.gate_to_gate : score.rest_to_centre;
  if (!time) return std::nullopt;
  if (rules.counts == Counted::dead_end) {
    score.value = marks_lost(*run.dead_ends, rules);
    return score;
  }
  score.maze_time = maze_time_part(run.begin, rules);
  score.bonus = run.touched ? 0 : rules.untouched_bonus;
  score.penalty = run.touched ? rules.touch_penalty : 0;
  score.value = *time + score.maze_time + score.penalty - score.bonus;
  return score;
}

}  // namespace

std::optional<LapTime> fastest_lap(const DriveRun& run, MazeTime until) {
  std::optional<LapTime> fastest;
  MazeTime begin = run.gate_out.value_or(0);
  for (std::size_t i = 0; run.gate_out && i < run.laps.size() && run.laps[i] <= until; ++i) {
    const MazeTime time = run.laps[i] - begin;
    begin = run.laps[i];
    if (!fastest || time < fastest->time) fastest = {time, static_cast<int>(i) + 1};
  }
  return fastest;
}

int starts_of(const DriveRecord& record) {
  return static_cast<int>(std::count_if(record.runs.begin(), record.runs.end(),
                                        [](const DriveRun& run) { return run.kind != DriveRun::Kind::home; }));
}

MazeTime maze_time_part(MazeTime before, const DriveRules& rules) {
  const int divisor = rules.maze_time_divisor;
  return divisor == 0 ? 0 : (before + divisor / 2) / divisor;
}

std::int64_t marks_lost(const DeadEndCount& count, const DriveRules& rules) {
  const std::int64_t full = rules.marks * std::int64_t{1'000'000};
  const std::int64_t whole = std::int64_t{count.all} * std::max({count.steps, count.fewest_steps, 1});
  const std::int64_t part = std::int64_t{count.seen} * count.fewest_steps;
  return whole == 0 ? full : full - (full * part + whole / 2) / whole;
}

DriveScore score(const DriveRecord& record, const DriveRules& rules) {
  DriveScore score;
  score.outcome = record.outcome;
  for (std::size_t i = 0; i < record.runs.size(); ++i) {
    auto run = score_of(record.runs[i], rules);
    if (!run) continue;
    run->run = i;
    if (!score.best || run->value < score.runs[*score.best].value) score.best = score.runs.size();
    score.runs.push_back(*run);
  }
  return score;
}

}  // namespace labmouse
