#include "labmouse/lab/records/drive_json.hpp"

namespace labmouse {

Json rules_json(const DriveRules& rules) {
  Json json = {{"name", rules.name},
               {"source", rules.source},
               {"time_limit", rules.time_limit},
               {"most_runs", rules.most_runs},
               {"maze_time_divisor", rules.maze_time_divisor},
               {"gate_to_gate", rules.gate_to_gate},
               {"touch_penalty", rules.touch_penalty},
               {"untouched_bonus", rules.untouched_bonus}};
  // If runs count, the fields are left out, which keeps records and stores of earlier versions unchanged.
  if (rules.counts != Counted::run) json["counts"] = name_of(rules.counts);
  if (rules.counts == Counted::dead_end) json["marks"] = rules.marks;
  return json;
}

Json dead_ends_json(const DeadEndCount& count) {
  return {{"seen", count.seen}, {"all", count.all}, {"steps", count.steps}, {"fewest_steps", count.fewest_steps}};
}

Json score_json(const DriveScore& score) {
  if (!score.best) return nullptr;
  const DriveRunScore& best = score.runs[*score.best];
  Json json = {{"value", best.value},
               {"run", best.run + 1},
               {"gate_to_gate", or_null(best.gate_to_gate)},
               {"rest_to_centre", or_null(best.rest_to_centre)},
               {"maze_time", best.maze_time},
               {"bonus", best.bonus}};
  // The fields are left out without a penalty and without laps, which keeps records of earlier versions unchanged.
  if (best.penalty != 0) json["penalty"] = best.penalty;
  if (best.lap != 0) json["lap"] = best.lap;
  return json;
}

}  // namespace labmouse
