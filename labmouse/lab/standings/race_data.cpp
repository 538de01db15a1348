#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/records/settings_json.hpp"
#include "labmouse/lab/standings/mms_report.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/race_notes.hpp"
#include "labmouse/lab/standings/race_report.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json maze_json(const NamedMaze& maze, const Bound& bound) {
  return {{"name", maze.name},
          {"width", maze.maze.size().width},
          {"height", maze.maze.size().height},
          {"optimum", or_null(bound.optimum)},
          {"bound", or_null(bound.score)}};
}

std::string outcome_text(const ContestResult& contest) {
  if (contest.score.outcome != Outcome::forfeit) return std::string(name_of(contest.score.outcome));
  return fmt::format("{}: {}", name_of(contest.score.outcome), name_of(contest.reason));
}

void add_missteps(const Missteps& missteps, Json& json) {
  if (missteps == Missteps()) return;
  json["blocked_steps"] = missteps.blocked.steps;
  json["void_rotations"] = missteps.void_rotations.steps;
  json["cut_movements"] = missteps.cut_movements.steps;
  json["idle_resets"] = missteps.idle_resets.steps;
}

Json result_json(const Race& race, const ContestResult& contest) {
  const bool solved = contest.score.value.has_value();
  Json json = {{"maze", race.mazes[contest.maze].name},
               {"seed", contest.seed},
               {"outcome", outcome_text(contest)},
               {"score", or_null(contest.score.value)},
               {"exploration_steps", contest.score.exploration_steps},
               {"speed_steps", solved ? Json(contest.score.speed_steps) : Json(nullptr)},
               {"discovered_share", contest.coverage.discovered},
               {"visited_share", contest.coverage.visited},
               {"microseconds_per_decision", contest.microseconds / std::max(1, contest.decisions)}};
  add_missteps(contest.missteps, json);
  if (!contest.last_words.empty()) json["last_words"] = contest.last_words;
  for (const Count& count : contest.counts) json["counts"][count.name] = count.value;
  return json;
}

Json mouse_json(const Race& race, const Standing& standing) {
  const Contestant& mouse = race.mice[standing.mouse];
  Json results = Json::array();
  for (const ContestResult& contest : race.results)
    if (contest.mouse == standing.mouse && contest.done) results.push_back(result_json(race, contest));
  return {{"name", mouse.name},
          {"parameters", settings_json(mouse.settings)},
          {"contestant", !mouse.reference},
          {"solved", standing.solved},
          {"runs", standing.runs},
          {"mean_score", or_null(standing.mean_score)},
          {"penalised_mean", or_null(standing.penalised_mean)},
          {"interval", standing.runs > 0 ? Json{standing.interval.low, standing.interval.high} : Json(nullptr)},
          {"mean_ratio", or_null(standing.mean_ratio)},
          {"mean_exploration_steps", or_null(standing.mean_exploration)},
          {"mean_speed_over_optimum", or_null(standing.mean_speed_over_optimum)},
          {"optimal_share", standing.optimal_share},
          {"mean_discovered_share", or_null(standing.mean_discovered)},
          {"mean_visited_share", or_null(standing.mean_visited)},
          {"microseconds_per_decision", standing.microseconds_per_decision},
          {"results", std::move(results)}};
}

Json lines_of(std::string_view text) {
  Json lines = Json::array();
  for (std::size_t end = 0; !text.empty(); text.remove_prefix(end + 1)) {
    end = text.find('\n');
    lines.push_back(text.substr(0, end));
  }
  return lines;
}

}  // namespace

Json race_json(const Race& race, const std::vector<SkippedFile>& skipped, const MmsRace* mms) {
  Json json;
  json["labmouse"] = version();
  json["compiler"] = compiler();
  json["processor"] = processor();
  json["seed"] = race.order.seed;
  json["budget"] = race.order.rules.budget;
  json["stopped"] = race.stopped || (mms != nullptr && mms->stopped);
  json["mazes"] = Json::array();
  for (std::size_t i = 0; i < race.mazes.size(); ++i) json["mazes"].push_back(maze_json(race.mazes[i], race.bounds[i]));
  json["mice"] = Json::array();
  for (const Standing& standing : standings_of(race)) json["mice"].push_back(mouse_json(race, standing));
  json["notes"] = lines_of(notes_of(race));
  if (mms != nullptr) json["groups"] = Json::array({group_json(*mms)});
  json["skipped"] = Json::array();
  for (const SkippedFile& file : skipped) {
    Json reasons = Json::array();
    for (const Problem& problem : file.problems) reasons.push_back(describe(file.path, problem));
    json["skipped"].push_back({{"path", file.path}, {"reasons", std::move(reasons)}});
  }
  return json;
}

std::string text_of(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string json_of(const Race& race, const std::vector<SkippedFile>& skipped, const MmsRace* mms) {
  return text_of(race_json(race, skipped, mms));
}

std::string csv_of(const Race& race) {
  std::string text =
      "mouse,maze,seed,outcome,score,exploration_steps,speed_steps,optimum,bound,microseconds_per_decision,discovered_"
      "share,"
      "visited_share\n";
  for (const ContestResult& contest : race.results) {
    if (!contest.done) continue;
    const Bound& bound = race.bounds[contest.maze];
    const auto field = [](const auto& value) { return value ? fmt::format("{}", *value) : std::string(); };
    text += fmt::format("{},{},{},{},{},{},{},{},{},{:.3f},{},{}\n", csv_field(race.mice[contest.mouse].name),
                        csv_field(race.mazes[contest.maze].name), contest.seed, csv_field(outcome_text(contest)),
                        field(contest.score.value), contest.score.exploration_steps,
                        contest.score.value ? fmt::format("{}", contest.score.speed_steps) : "", field(bound.optimum),
                        field(bound.score), contest.microseconds / std::max(1, contest.decisions),
                        contest.coverage.discovered, contest.coverage.visited);
  }
  return text;
}

}  // namespace labmouse
