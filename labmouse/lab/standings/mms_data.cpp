#include <fmt/format.h>

#include "labmouse/lab/records/mms_fields.hpp"
#include "labmouse/lab/standings/mms_report.hpp"
#include "labmouse/lab/standings/mms_standings.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json maze_json(const NamedMaze& maze, const MmsBound& bound) {
  return {{"name", maze.name},
          {"width", maze.maze.size().width},
          {"height", maze.maze.size().height},
          {"best_run", or_null(bound.run)},
          {"best_score", or_null(bound.score)}};
}

Json result_json(const MmsRace& race, const MmsResult& result) {
  const MmsRun& run = result.run;
  const MmsBound& bound = race.bounds[result.maze];
  return {{"maze", race.mazes[result.maze].name},
          {"outcome", name_of(run.outcome)},
          {"end", run.end},
          {"solved", run.statistics.solved},
          {"score", short_json(run.statistics.score)},
          {"possible_score", or_null(bound.score)},
          {"ratio", or_null(score_ratio(race, result))},
          {"best_run", or_null(best_run(run.statistics))},
          {"possible_run", or_null(bound.run)},
          {"run_ratio", or_null(run_ratio(race, result))},
          {"statistics", statistics_json(run.statistics)},
          {"lines", run.lines},
          {"invalid_lines", run.invalid_lines},
          {"log", run.log},
          {"errors", last_lines(run.errors)},
          {"simulated_seconds", run.clock},
          {"seconds", run.seconds}};
}

Json mouse_json(const MmsRace& race, const MmsStanding& standing) {
  Json outcomes = Json::object(), results = Json::array();
  for (std::size_t outcome = 0; outcome < standing.outcomes.size(); ++outcome)
    if (standing.outcomes[outcome] > 0)
      outcomes[std::string(name_of(static_cast<MmsOutcome>(outcome)))] = standing.outcomes[outcome];
  for (const MmsResult& result : race.results)
    if (result.mouse == standing.mouse && result.done) results.push_back(result_json(race, result));
  return {{"name", race.mice[standing.mouse].name},
          {"solved", standing.solved},
          {"runs", standing.runs},
          {"mean_score", or_null(standing.mean_score)},
          {"interval", standing.runs > 0 ? Json{standing.interval.low, standing.interval.high} : Json(nullptr)},
          {"mean_solved_score", or_null(standing.mean_solved_score)},
          {"mean_ratio", or_null(standing.mean_ratio)},
          {"mean_best_run", or_null(standing.mean_best_run)},
          {"mean_run_ratio", or_null(standing.mean_run_ratio)},
          {"mean_total", or_null(standing.mean_total)},
          {"mean_seconds", or_null(standing.mean_seconds)},
          {"lines", standing.lines},
          {"invalid_lines", standing.invalid_lines},
          {"outcomes", std::move(outcomes)},
          {"results", std::move(results)}};
}

std::string csv_number(const std::optional<double>& value) { return value ? fmt::format("{}", *value) : ""; }

std::string csv_line(const MmsRace& race, const MmsResult& result) {
  const MmsRun& run = result.run;
  const MmsBound& bound = race.bounds[result.maze];
  std::string line = fmt::format("{},{},{},{},{},{},{},{}", csv_field(race.mice[result.mouse].name),
                                 csv_field(race.mazes[result.maze].name), name_of(run.outcome), csv_field(run.end),
                                 run.statistics.solved, csv_number(best_run(run.statistics)), csv_number(bound.run),
                                 csv_number(bound.score));
  for (const MmsStatistic& statistic : mms_statistics) line += fmt::format(",{}", run.statistics.*statistic.value);
  return line + fmt::format(",{},{},{:.3f},{:.3f}\n", run.lines, run.invalid_lines, run.clock, run.seconds);
}

}  // namespace

Json group_json(const MmsRace& race) {
  Json json = {{"world", "mms"},
               {"formula", mms_formula},
               {"strict", race.order.options.strict},
               {"presses", race.order.options.presses},
               {"stopped", race.stopped}};
  json["mazes"] = Json::array();
  for (std::size_t i = 0; i < race.mazes.size(); ++i) json["mazes"].push_back(maze_json(race.mazes[i], race.bounds[i]));
  json["mice"] = Json::array();
  for (const MmsStanding& standing : mms_standings_of(race)) json["mice"].push_back(mouse_json(race, standing));
  return json;
}

std::string csv_of(const MmsRace& race) {
  std::string text = "mouse,maze,outcome,end,solved,best_run,possible_run,possible_score";
  for (const MmsStatistic& statistic : mms_statistics) text += fmt::format(",{}", statistic.name);
  text += ",lines,invalid_lines,simulated_seconds,seconds\n";
  for (const MmsResult& result : race.results)
    if (result.done) text += csv_line(race, result);
  return text;
}

}  // namespace labmouse
