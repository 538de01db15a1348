#include "labmouse/lab/drive/drive_world.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "labmouse/lab/drive/drive_results.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/pictures/drive_picture.hpp"
#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/maze/routes.hpp"

namespace labmouse {
namespace {

DriveBound bound_in(const MazeFacts& facts) {
  DriveBound bound;
  if (facts.best_run) bound.fastest = static_cast<DriveTime>(*facts.best_run);
  if (facts.bound) bound.score = std::llround(*facts.bound * 1e6);
  return bound;
}

/// Adds what depends on the rules alone.
WorldTraits with_rules(WorldTraits its, const DriveRules& rules) {
  its.formula = formula_of(rules);
  its.unit = unit_of(rules.counts);
  its.score_place = {.key = "score", .inner = "value", .unit = 1e-6, .least = -in_seconds(rules.untouched_bonus)};
  its.limit_score = in_seconds(rules.time_limit);
  its.has_ratio = rules.counts != Counted::dead_end;
  if (rules.counts == Counted::dead_end) its.score_place.most = its.limit_score = rules.marks;
  its.tie_breaker = "search_us";
  its.why_no_bound = "in which no mouse could score";
  return its;
}

/// Fills in the figures that all worlds have.
void add_figures(const DrivenContest& driven, const DriveScore& score, const DriveBound& bound, DriveFigures& figures) {
  const DriveRunScore counting = score.best ? score.runs[*score.best] : DriveRunScore();
  if (score.best) figures.score = JsonText{score_json(score).dump()};
  figures.search = search_time_of(driven.record);
  figures.best = best_of(score);
  figures.excess = excess_of(best_of(score), bound);
  figures.starts = starts_of(driven.record);
  figures.decisions = driven.record.decisions;
  figures.replanned = driven.record.replanned;
  if (driven.coverage) {
    figures.discovered = driven.coverage->discovered;
    figures.visited = driven.coverage->visited;
  }
  if (!driven.words.empty()) figures.words = driven.words;
  figures.score_us = score.value();
  figures.gate_to_gate = counting.gate_to_gate;
  figures.rest_to_centre = counting.rest_to_centre;
}

}  // namespace

DriveWorld::DriveWorld(WorldTraits its, const DriveRules& rules, std::shared_ptr<const DriveModel> model)
    : World(with_rules(std::move(its), rules)), rules_(rules), model_(sharing_tables(std::move(model))) {}

std::string DriveWorld::refuse(const Maze& maze) const { return refuse_to_drive_in(maze, rules_, *model_); }

Settings DriveWorld::settings(const Contestant& mouse) const { return settings_in_seconds(mouse); }

MazeFacts DriveWorld::facts(const Maze& maze) const {
  const DriveBound bound = drive_bound_of(maze, rules_, *model_);
  return {bound.score ? std::optional(in_seconds(*bound.score)) : std::nullopt, bound.fastest, reachable_cells(maze)};
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
  const std::shared_ptr<DriveFigures> figures = own_figures(driven, score);
  add_figures(driven, score, bound, *figures);
  result.figures = figures;
  if (!driven.started) result.never_started = driven.words.substr(0, driven.words.find('\n'));
  if (score.value()) add_score(*score.value(), bound, rules_, result);
  if (driven.record.reason == ForfeitReason::not_judged) leave_unjudged(result);
  result.done = !interrupted;
  return kept(mouse, maze, result.seed, std::move(driven), keep);
}

std::string DriveWorld::refuse_in_laps(const Contestant& mouse) const {
  if (rules_.counts != Counted::lap || !mouse.external || mouse.parts) return "";
  return fmt::format(
      "'{}' is an external mouse; by rules with counts = \"lap\" no program is asked, because all mice drive the same "
      "course: choose other --rules",
      shown(mouse.name));
}

std::string DriveWorld::bound_words(const Race& race) const {
  if (rules_.counts == Counted::dead_end) return "No mouse loses 0 marks, as each dead end costs steps.";
  return fmt::format("Best possible: {} s on average, {}.", columns::number(mean_bound(race), 3),
                     rules_.counts == Counted::lap ? "the fastest lap without errors"
                     : traits().is_stochastic
                         ? "by a mouse without errors that knows the maze but must first search a route"
                         : "by a mouse that knows the maze but must first search a route");
}

std::vector<Condition> drive_conditions(const DriveRules& rules, const DriveModel& model, RobotParts parts) {
  return {{"rules", JsonText{rules_json(rules).dump()}},
          {"robot", JsonText{robot_json(model.robot, parts).dump()}},
          {"tables", hash_text(model.tables.hash)}};
}

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
    if (world_of(file) != traits().name) file.added_world = traits().name;
    if (keep.record) held.record = write_drive_record(file);
    if (keep.picture) held.picture = draw_contest(file);
  }
  return held;
}

}  // namespace labmouse
