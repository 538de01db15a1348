#include <fmt/format.h>

#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/records/settings_json.hpp"
#include "labmouse/lab/robots/robot_json.hpp"
#include "labmouse/lab/standings/drive_report.hpp"
#include "labmouse/lab/standings/drive_standings.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::ordered_json;

Json maze_json(const NamedMaze& maze, const DriveBound& bound) {
  return {{"name", maze.name},
          {"width", maze.maze.size().width},
          {"height", maze.maze.size().height},
          {"fastest_us", or_null(bound.fastest)},
          {"bound_us", or_null(bound.score)}};
}

std::string outcome_text(const DriveResult& result) {
  const std::string outcome(name_of(result.score.outcome));
  return result.score.outcome == DriveOutcome::forfeit ? fmt::format("{}: {}", outcome, name_of(result.reason))
                                                       : outcome;
}

Json result_json(const DriveRace& race, const DriveResult& result) {
  return {{"maze", race.mazes[result.maze].name},
          {"seed", result.seed},
          {"outcome", outcome_text(result)},
          {"score", score_json(result.score)},
          {"search_us", result.search},
          {"best_us", or_null(result.best)},
          {"excess", or_null(excess_of(race, result))},
          {"proven", result.proven},
          {"starts", result.starts},
          {"decisions", result.decisions},
          {"replanned", result.replanned}};
}

Json mouse_json(const DriveRace& race, const DriveStanding& standing) {
  const Contestant& mouse = race.mice[standing.mouse];
  Json results = Json::array();
  for (const DriveResult& result : race.results)
    if (result.mouse == standing.mouse && result.done) results.push_back(result_json(race, result));
  return {{"name", mouse.name},
          {"parameters", settings_json(settings_in_seconds(mouse))},
          {"scored", standing.scored},
          {"runs", standing.runs},
          {"mean_score", or_null(standing.mean_score)},
          {"interval", standing.mean_score ? Json{standing.interval.low, standing.interval.high} : Json(nullptr)},
          {"mean_ratio", or_null(standing.mean_ratio)},
          {"mean_search", or_null(standing.mean_search)},
          {"mean_best", or_null(standing.mean_best)},
          {"mean_excess", or_null(standing.mean_excess)},
          {"mean_starts", or_null(standing.mean_starts)},
          {"optimal", standing.optimal},
          {"proven", standing.proven},
          {"decisions", standing.decisions},
          {"replanned", standing.replanned},
          {"results", std::move(results)}};
}

std::string csv_line(const DriveRace& race, const DriveResult& result) {
  const auto field = [](const auto& value) { return value ? fmt::format("{}", *value) : std::string(); };
  const DriveBound& bound = race.bounds[result.maze];
  const DriveRunScore* best = result.score.best ? &result.score.runs[*result.score.best] : nullptr;
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(race.mice[result.mouse].name),
                     csv_field(race.mazes[result.maze].name), result.seed, csv_field(outcome_text(result)),
                     field(result.score.value()), best != nullptr ? field(best->gate_to_gate) : "",
                     best != nullptr ? field(best->rest_to_centre) : "", result.search, field(result.best),
                     field(bound.fastest), field(bound.score), result.proven, result.starts, result.decisions);
}

}  // namespace

Json group_json(const DriveRace& race) {
  const DriveModel& model = *race.order.model;
  Json json = {{"world", "seconds"},
               {"formula", formula_of(race.order.rules)},
               {"rules", rules_json(race.order.rules)},
               {"robot", robot_json(model.robot)},
               {"tables", hash_text(model.tables.hash)},
               {"stopped", race.stopped}};
  json["mazes"] = Json::array();
  for (std::size_t i = 0; i < race.mazes.size(); ++i) json["mazes"].push_back(maze_json(race.mazes[i], race.bounds[i]));
  json["mice"] = Json::array();
  for (const DriveStanding& standing : drive_standings_of(race)) json["mice"].push_back(mouse_json(race, standing));
  return json;
}

std::string json_of(const DriveRace& race, const std::vector<SkippedFile>& skipped) {
  Race none;
  none.order.seed = race.order.seed;
  none.stopped = race.stopped;
  Json json = race_json(none, skipped);
  json.erase("budget");
  json["notes"] = Json::array();
  json["groups"] = Json::array({group_json(race)});
  return text_of(json);
}

std::string csv_of(const DriveRace& race) {
  std::string text =
      "mouse,maze,seed,outcome,score_us,gate_to_gate_us,rest_to_centre_us,search_us,best_us,fastest_us,bound_us,proven,"
      "starts,"
      "decisions\n";
  for (const DriveResult& result : race.results)
    if (result.done) text += csv_line(race, result);
  return text;
}

}  // namespace labmouse
