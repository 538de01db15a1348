#include <fmt/format.h>

#include <algorithm>

#include "labmouse/contest/script.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/record_file.hpp"

namespace labmouse {

ReplayResult replay(const RecordFile& file, const Maze& maze) {
  std::vector<Action> actions;
  for (const StepRecord& step : file.run.steps) actions.push_back(step.action);
  Script script(maze.size(), std::move(actions));
  Rules rules = file.rules;
  // A record without its last line may stop anywhere: play as far as it goes.
  if (!file.ended) rules.budget = std::min(rules.budget, static_cast<int>(file.run.steps.size()));
  ReplayResult result{run(maze, rules, script), ""};
  // What the mouse counted and thought cannot be played again, so it is taken as it stands.
  result.run.counts = file.run.counts;
  result.run.reasons = file.run.reasons;
  const auto& played = result.run.steps;
  for (std::size_t i = 0; i < file.run.steps.size(); ++i) {
    if (i >= played.size()) {
      result.disagreement = fmt::format("step {} is recorded, but the contest had ended", i + 1);
      return result;
    }
    const StepRecord &was = file.run.steps[i], &is = played[i];
    if (was == is) continue;
    result.disagreement = fmt::format(
        "step {}: recorded at ({},{}) heading {}, reading {} {} {}{}; played at ({},{}) heading {}, reading {} {} {}{}", i + 1,
        was.pose.cell.x, was.pose.cell.y, name_of(was.pose.heading), was.sighting.left, was.sighting.ahead,
        was.sighting.right, was.blocked ? ", blocked" : "", is.pose.cell.x, is.pose.cell.y, name_of(is.pose.heading),
        is.sighting.left, is.sighting.ahead, is.sighting.right, is.blocked ? ", blocked" : "");
    return result;
  }
  if (file.ended && played.size() != file.run.steps.size())
    result.disagreement = fmt::format("the record ends after step {}, but the contest had not", file.run.steps.size());
  else if (file.ended && (result.run.outcome != file.run.outcome || result.run.end != file.run.end))
    result.disagreement = fmt::format("the record ends '{}' at ({},{}); played, it ends '{}' at ({},{})",
                                      name_of(file.run.outcome), file.run.end.cell.x, file.run.end.cell.y,
                                      name_of(result.run.outcome), result.run.end.cell.x, result.run.end.cell.y);
  return result;
}

}  // namespace labmouse
