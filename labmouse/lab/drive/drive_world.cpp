#include "labmouse/lab/drive/drive_world.hpp"

#include <any>
#include <utility>

#include "labmouse/lab/drive/drive_results.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/pictures/drive_picture.hpp"
#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/maze/routes.hpp"

namespace labmouse {
namespace {

/// What is found out about a maze once.
struct Prepared {
  DriveBound bound;
  CellSet reachable;
};

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
          Prepared{bound, reachable_cells(maze)}};
}

Held DriveWorld::hold(const Race& race, ContestResult& result, Keep keep, const std::atomic<bool>* stop) const {
  const Contestant& mouse = race.mice[result.mouse];
  const NamedMaze& maze = race.mazes[result.maze];
  const auto& prepared = std::any_cast<const Prepared&>(race.facts[result.maze].prepared);
  DrivenContest driven = drive(mouse, maze.maze, result, prepared.reachable, keep.record || keep.picture, stop);
  const bool interrupted = driven.record.reason == ForfeitReason::interrupted;
  if (interrupted && !keep.record && !keep.picture) return {};
  const DriveScore score = labmouse::score(driven.record, rules_);
  result.outcome = outcome_of(driven.record, score);
  result.figures = figures(driven, score, prepared.bound);
  if (!driven.started) result.never_started = driven.words.substr(0, driven.words.find('\n'));
  if (score.value()) add_score(*score.value(), prepared.bound, rules_, result);
  if (driven.record.reason == ForfeitReason::not_judged) leave_unjudged(result);
  result.done = !interrupted;
  return kept(mouse, maze, result.seed, std::move(driven), keep);
}

double DriveWorld::limit_score() const { return in_seconds(rules_.time_limit); }

ScorePlace DriveWorld::score_place() const { return {"score", "value", 1e-6, -in_seconds(rules_.untouched_bonus)}; }

Held DriveWorld::kept(const Contestant& mouse, const NamedMaze& maze, std::uint64_t seed, DrivenContest driven,
                      Keep keep) const {
  Held held;
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
    file.record = driven.record;
    const DriveScore scored = score(file.record, rules_);
    if (scored.best) file.recorded_score = scored.runs[*scored.best];
    file.physical = std::move(driven.physical);
    if (keep.record) held.record = write_drive_record(file);
    if (keep.picture) held.picture = draw_contest(file);
  }
  held.run = std::move(driven.record);
  return held;
}

}  // namespace labmouse
