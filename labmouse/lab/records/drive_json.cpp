#include "labmouse/lab/records/drive_json.hpp"

#include "labmouse/lab/robots/drive_rules_keys.hpp"

namespace labmouse {
namespace {

template <class Value>
void write(Json& json, const char* key, const Value& value) {
  json[key] = value;
}
/// If runs count, the field is left out, which keeps records and stores of earlier versions unchanged.
void write(Json& json, const char* key, Counted counts) {
  if (counts != Counted::run) json[key] = name_of(counts);
}

}  // namespace

Json rules_json(const DriveRules& rules) {
  Json json = {{"name", rules.name}};
  for (const bool later : {false, true})
    for (const DriveRulesKey& key : drive_rules_keys)
      if (key.later == later && key.in_json_of(rules.counts))
        std::visit([&](auto member) { write(json, key.json_name, rules.*member); }, key.member);
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
