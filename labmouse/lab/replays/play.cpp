#include "labmouse/lab/replays/play.hpp"

#include <fmt/format.h>

#include "labmouse/contest/coverage.hpp"
#include "labmouse/contest/score.hpp"
#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/records/explanation.hpp"
#include "labmouse/lab/replays/fields.hpp"
#include "labmouse/lab/replays/lost_steps.hpp"
#include "labmouse/lab/replays/maze_data.hpp"
#include "labmouse/lab/replays/play_frames.hpp"
#include "labmouse/lab/replays/steps_text.hpp"
#include "labmouse/lab/text/optional_json.hpp"

namespace labmouse {
namespace {

std::string outcome_words(const RecordFile& file) {
  if (!file.ended && file.run.outcome != Outcome::finished)
    return fmt::format("the record breaks off after step {}", file.run.steps.size());
  std::string words(name_of(file.run.outcome));
  if (file.run.outcome == Outcome::forfeit && !file.run.steps.empty())
    words += fmt::format(": {}", name_of(file.run.steps.back().action.reason));
  return words;
}

Json rules_json(const Rules& rules) {
  return {{"budget", rules.budget}, {"search_factor", rules.search_factor}, {"stride", rules.stride}};
}

Json counts_json(const std::vector<Count>& counts) {
  Json list = Json::array();
  for (const Count& count : counts) list.push_back({{"name", count.name}, {"value", count.value}});
  return list;
}

/// What the contest was and how it went.
Json header_json(const RecordFile& file) {
  const Score result = score(file.run, file.rules);
  const Bound bound = bound_of(*file.maze, file.rules);
  const Coverage coverage = coverage_of(file.run, *file.maze);
  return {{"world", file.world.empty() ? "steps" : file.world},
          {"traits", traits_json({.bound = "the best possible score: that of a mouse that knows the maze",
                                  .runs = {"search", "speed run"}})},
          {"mouse", file.mouse},
          {"maze", maze_data(file.maze_name, *file.maze)},
          {"rules", rules_json(file.rules)},
          {"seed", file.seed},
          {"outcome", outcome_words(file)},
          {"finished", result.value.has_value()},
          {"score", or_null(result.value)},
          {"bound", or_null(bound.score)},
          {"optimum", or_null(bound.optimum)},
          {"search_steps", result.search_steps},
          {"speed_steps", result.speed_steps},
          {"discovered", coverage.discovered},
          {"visited", coverage.visited},
          {"last_words", file.run.last_words},
          {"counts", counts_json(file.run.counts)},
          {"checked", checked_line(file)},
          {"ended", file.ended}};
}

Json candidate_json(const Candidate& candidate) {
  const Wall& wall = candidate.wall;
  return {{"wall", candidate.goal ? Json(nullptr) : Json{wall.cell.x, wall.cell.y, name_of(wall.side)}},
          {"goal", candidate.goal},
          {"seen_from", cell_json(candidate.seen_from)},
          {"through", static_cast<double>(candidate.through) / costs_a_step},
          {"travel", candidate.travel},
          {"worth", candidate.worth},
          {"score", candidate.score / costs_a_step}};
}

Json choice_json(const StepReasons& choice) {
  const Reasons& reasons = choice.reasons;
  Json candidates = Json::array();
  for (const Candidate& candidate : reasons.candidates) candidates.push_back(candidate_json(candidate));
  return {{"frame", choice.step - 1},
          {"ground", ground_words(reasons)},
          {"candidates", std::move(candidates)},
          {"chosen", reasons.chosen},
          {"known", static_cast<double>(reasons.known) / costs_a_step},
          {"hope", reasons.hope / costs_a_step},
          {"price", reasons.price / costs_a_step}};
}

}  // namespace

Json play_json(const RecordFile& file) {
  Json play = header_json(file);
  add_frames(file, play);
  add_steps(file, play);
  play["route"] = route_json(*file.maze, file.rules);
  play["distances"] = distances_json(*file.maze, file.rules.stride);
  play["reasons"] = Json::array();
  for (const StepReasons& choice : file.run.reasons) play["reasons"].push_back(choice_json(choice));
  play["events"] = Json::array();
  play["loses"] = LossMeter(*file.maze, file.rules).by_step(file.run);
  return play;
}

}  // namespace labmouse
