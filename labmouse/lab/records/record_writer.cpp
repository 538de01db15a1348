
#include "labmouse/contest/score.hpp"
#include "labmouse/lab/records/record_file.hpp"
#include "labmouse/lab/records/record_maze.hpp"
#include "labmouse/lab/records/record_reasons.hpp"
#include "labmouse/lab/records/settings_json.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {
namespace {

Json cell_json(Cell cell) { return {cell.x, cell.y}; }

Json mouse_json(const RecordFile& file) {
  Json mouse = {{"name", file.mouse}, {"parameters", settings_json(file.settings)}};
  if (!file.spec.empty()) mouse["spec"] = file.spec;
  if (!file.interpreter.empty()) mouse["interpreter"] = file.interpreter;
  return mouse;
}

Json header_json(const RecordFile& file) {
  Json header = {
      {"labmouse", "record"},
      {"format", 1},
      {"version", version()},
      {"maze", record_maze_json(file.maze_name, *file.maze)},
      {"mouse", mouse_json(file)},
      {"seed", file.seed},
      {"rules",
       {{"budget", file.rules.budget}, {"search_factor", file.rules.search_factor}, {"stride", file.rules.stride}}}};
  if (!file.world.empty()) header["world"] = file.world;
  return header;
}

Json action_json(const Action& action) {
  switch (action.kind) {
    case Action::Kind::step:
      return Json{action.rotation, action.movement};
    case Action::Kind::reset:
      return "reset";
    case Action::Kind::forfeit:
      return "forfeit: " + std::string(name_of(action.reason));
  }
  return nullptr;
}

Json step_json(const StepRecord& step) {
  return {{"run", step.run == Run::speed ? "speed" : "search"},
          {"step", step.step},
          {"cell", cell_json(step.pose.cell)},
          {"heading", name_of(step.pose.heading)},
          {"reading", {step.sighting.left, step.sighting.ahead, step.sighting.right}},
          {"action", action_json(step.action)},
          {"blocked", step.blocked}};
}

Json end_json(const RecordFile& file) {
  const Score result = score(file.run, file.rules);
  Json end = {
      {"outcome", name_of(result.outcome)},       {"cell", cell_json(file.run.end.cell)},
      {"heading", name_of(file.run.end.heading)}, {"search_steps", result.search_steps},
      {"speed_steps", result.speed_steps},        {"score", result.value ? Json(*result.value) : Json(nullptr)}};
  if (!file.run.last_words.empty()) end["last_words"] = file.run.last_words;
  for (const Count& count : file.run.counts) end["counts"][count.name] = count.value;
  return end;
}

}  // namespace

std::string write_record(const RecordFile& file) {
  std::string text = record_line(header_json(file));
  auto reasons = file.run.reasons.begin();
  for (const StepRecord& step : file.run.steps) {
    Json json = step_json(step);
    if (reasons != file.run.reasons.end() && reasons->step == step.step)
      json["reasons"] = reasons_json(reasons++->reasons);
    text += record_line(json);
  }
  return text + record_line(end_json(file));
}

}  // namespace labmouse
