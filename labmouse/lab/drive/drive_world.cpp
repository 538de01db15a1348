#include "labmouse/lab/drive/drive_world.hpp"

#include <utility>

#include "labmouse/lab/drive/drive_figures.hpp"
#include "labmouse/lab/drive/drive_results.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/pictures/drive_picture.hpp"
#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/maze/routes.hpp"

namespace labmouse {
namespace {

DriveBound bound_in(const MazeFacts& facts) {
  const auto time = [&](DriveMazeFigure figure) {
    return std::get_if<std::int64_t>(&facts.figures[static_cast<std::size_t>(figure)]);
  };
  DriveBound bound;
  if (const auto* fastest = time(DriveMazeFigure::fastest)) bound.fastest = static_cast<DriveTime>(*fastest);
  if (const auto* score = time(DriveMazeFigure::bound)) bound.score = *score;
  return bound;
}

/// In the order of the world's list; `own` are those between `excess` and `words`.
std::vector<Value> figures_of(const DrivenContest& driven, const DriveScore& score, const DriveBound& bound,
                              const std::vector<Value>& own) {
  const auto best = best_of(score);
  const DriveRunScore counting = score.best ? score.runs[*score.best] : DriveRunScore();
  std::vector<Value> all = {score.best ? Value(JsonText{score_json(score).dump()}) : Value(nullptr),
                            std::int64_t{search_time_of(driven.record)}, or_none(best),
                            or_none(excess_of(best, bound))};
  all.insert(all.end(), own.begin(), own.end());
  all.insert(all.end(), {driven.words.empty() ? Value() : Value(driven.words), or_none(score.value()),
                         or_none(counting.gate_to_gate), or_none(counting.rest_to_centre)});
  return all;
}

}  // namespace

DriveWorld::DriveWorld(const DriveRules& rules, std::shared_ptr<const DriveModel> model)
    : rules_(rules), model_(sharing_tables(std::move(model))) {}

std::string DriveWorld::formula() const { return formula_of(rules_); }

std::string DriveWorld::refuse(const Maze& maze) const { return refuse_to_drive_in(maze); }

Settings DriveWorld::settings(const Contestant& mouse) const { return settings_in_seconds(mouse); }

MazeFacts DriveWorld::facts(const Maze& maze) const {
  const DriveBound bound = drive_bound_of(maze, rules_, *model_);
  return {bound.score ? std::optional(in_seconds(*bound.score)) : std::nullopt,
          {or_none(bound.fastest), or_none(bound.score)},
          reachable_cells(maze)};
}

ContestOutput DriveWorld::hold(const Race& race, ContestResult& result, Keep keep,
                               const std::atomic<bool>* stop) const {
  const Contestant& mouse = race.mice[result.mouse];
  const NamedMaze& maze = race.mazes[result.maze];
  const MazeFacts& facts = race.facts[result.maze];
  DrivenContest driven = drive(mouse, maze.maze, result, facts.reachable, keep.record || keep.picture, stop);
  const bool interrupted = driven.record.reason == ForfeitReason::interrupted;
  if (interrupted && !keep.record && !keep.picture) return {};
  const DriveScore score = labmouse::score(driven.record, rules_);
  const DriveBound bound = bound_in(facts);
  result.outcome = outcome_of(driven.record, score);
  result.figures = figures_of(driven, score, bound, own_figures(driven, score));
  if (!driven.started) result.never_started = driven.words.substr(0, driven.words.find('\n'));
  if (score.value()) add_score(*score.value(), bound, rules_, result);
  if (driven.record.reason == ForfeitReason::not_judged) leave_unjudged(result);
  result.done = !interrupted;
  return kept(mouse, maze, result.seed, std::move(driven), keep);
}

double DriveWorld::limit_score() const { return in_seconds(rules_.time_limit); }

ScorePlace DriveWorld::score_place() const { return {"score", "value", 1e-6, -in_seconds(rules_.untouched_bonus)}; }

ContestOutput DriveWorld::kept(const Contestant& mouse, const NamedMaze& maze, std::uint64_t seed, DrivenContest driven,
                               Keep keep) const {
  ContestOutput held;
  if (keep.record || keep.picture) {
    DriveRecordFile file;
    file.maze_name = maze.name;
    file.maze = maze.maze;
    file.mouse = mouse.name;
    file.spec = mouse.spec;
    file.settings = settings_in_seconds(mouse);
    file.seed = seed;
    file.tables_hash = model_->tables.hash;
    file.model = model_;
    file.rules = rules_;
    file.record = std::move(driven.record);
    const DriveScore scored = score(file.record, rules_);
    if (scored.best) file.recorded_score = scored.runs[*scored.best];
    file.physical = std::move(driven.physical);
    if (keep.record) held.record = write_drive_record(file);
    if (keep.picture) held.picture = draw_contest(file);
  }
  return held;
}

}  // namespace labmouse
