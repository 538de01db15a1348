#include <nlohmann/json.hpp>

#include "labmouse/contest/score.hpp"
#include "labmouse/lab/record_file.hpp"
#include "labmouse/lab/record_reasons.hpp"
#include "labmouse/lab/settings_json.hpp"
#include "labmouse/lab/version.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::ordered_json;

Json cell_json(Cell cell) { return {cell.x, cell.y}; }

/// The drawing for human eyes: with S and G where it can hold both, which it cannot on one cell.
std::string drawing_of(const Maze& maze) {
  const WriteResult marked = drawing_format.write(maze.with_start(maze.start(), Heading::north));
  if (marked.content) return *marked.content;
  return *drawing_format.write(maze.with_start({0, 0}, Heading::north).with_goals(centre_of(maze.size()))).content;
}

Json maze_json(const RecordFile& file) {
  const Maze& maze = *file.maze;
  Json goals = Json::array(), drawing = Json::array();
  maze.goals().for_each([&](Cell cell) { goals.push_back(cell_json(cell)); });
  // A drawing cannot hold every start and heading, so start and goals stand beside it.
  std::string text = drawing_of(maze);
  for (std::size_t end; (end = text.find('\n')) != std::string::npos; text.erase(0, end + 1))
    drawing.push_back(text.substr(0, end));
  return {{"name", file.maze_name},
          {"start", cell_json(maze.start())},
          {"heading", name_of(maze.start_heading())},
          {"goals", std::move(goals)},
          {"drawing", std::move(drawing)}};
}

Json header_json(const RecordFile& file) {
  return {{"labmouse", "record"},
          {"format", 1},
          {"version", version()},
          {"maze", maze_json(file)},
          {"mouse", {{"name", file.mouse}, {"parameters", settings_json(file.settings)}}},
          {"seed", file.seed},
          {"rules",
           {{"budget", file.rules.budget},
            {"exploration_factor", file.rules.exploration_factor},
            {"stride", file.rules.stride}}}};
}

Json action_json(const Action& action) {
  switch (action.kind) {
    case Action::Kind::step: return Json{action.rotation, action.movement};
    case Action::Kind::reset: return "reset";
    case Action::Kind::forfeit: return "forfeit: " + std::string(name_of(action.reason));
  }
  return nullptr;
}

Json step_json(const StepRecord& step) {
  return {{"run", step.run == Run::speed ? "speed" : "exploration"},
          {"step", step.step},
          {"cell", cell_json(step.pose.cell)},
          {"heading", name_of(step.pose.heading)},
          {"reading", {step.sighting.left, step.sighting.ahead, step.sighting.right}},
          {"action", action_json(step.action)},
          {"blocked", step.blocked}};
}

Json end_json(const RecordFile& file) {
  const Score result = score(file.run, file.rules);
  Json end = {{"outcome", name_of(result.outcome)},
              {"cell", cell_json(file.run.end.cell)},
              {"heading", name_of(file.run.end.heading)},
              {"exploration_steps", result.exploration_steps},
              {"speed_steps", result.speed_steps},
              {"score", result.value ? Json(*result.value) : Json(nullptr)}};
  if (!file.run.last_words.empty()) end["last_words"] = file.run.last_words;
  for (const Count& count : file.run.counts) end["counts"][count.name] = count.value;
  return end;
}

std::string line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

std::string write_record(const RecordFile& file) {
  std::string text = line(header_json(file));
  auto reasons = file.run.reasons.begin();
  for (const StepRecord& step : file.run.steps) {
    Json json = step_json(step);
    if (reasons != file.run.reasons.end() && reasons->step == step.step) json["reasons"] = reasons_json(reasons++->reasons);
    text += line(json);
  }
  return text + line(end_json(file));
}

}  // namespace labmouse
