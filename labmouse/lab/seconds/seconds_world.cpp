#include "labmouse/lab/seconds/seconds_world.hpp"

#include <fmt/format.h>

#include <array>

#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/drive_coverage.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/lab/bounds/drive_bound.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/mice/stoppable.hpp"
#include "labmouse/lab/pictures/drive_picture.hpp"
#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/robots/robot_json.hpp"
#include "labmouse/lab/seconds/drive_results.hpp"
#include "labmouse/lab/seconds/seconds_fields.hpp"
#include "labmouse/lab/seconds/seconds_figures.hpp"
#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/maze/routes.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {
namespace {

/// What is found out about a maze once.
struct Prepared {
  DriveBound bound;
  CellSet reachable;
};

/// In the order of SecondsFigure.
std::vector<Value> figures_of(const DriveRecord& record, const DriveScore& score, const DriveBound& bound,
                              const Coverage& coverage, std::string_view words) {
  bool proven = false;
  for (const DriveRun& run : record.runs)
    if (run.kind == DriveRun::Kind::fast) proven = run.known == run.hoped;
  const auto best = best_of(score);
  const DriveRunScore* counting = score.best ? &score.runs[*score.best] : nullptr;
  return {score.best ? Value(JsonText{score_json(score).dump()}) : Value(nullptr),
          std::int64_t{search_time_of(record)},
          or_none(best),
          or_none(excess_of(best, bound)),
          proven,
          std::int64_t{starts_of(record)},
          std::int64_t{record.decisions},
          std::int64_t{record.replanned},
          coverage.discovered,
          coverage.visited,
          words.empty() ? Value() : Value(std::string(words)),
          or_none(score.value()),
          counting != nullptr ? or_none(counting->gate_to_gate) : Value(nullptr),
          counting != nullptr ? or_none(counting->rest_to_centre) : Value(nullptr)};
}

class SecondsWorld final : public World {
 public:
  SecondsWorld(const DriveRules& rules, std::shared_ptr<const DriveModel> model)
      : rules_(rules), model_(sharing_tables(std::move(model))) {}

  std::string_view name() const override { return "seconds"; }
  std::string formula() const override { return formula_of(rules_); }
  std::vector<Condition> conditions() const override {
    return {{"rules", JsonText{rules_json(rules_).dump()}},
            {"robot", JsonText{robot_json(model_->robot).dump()}},
            {"tables", hash_text(model_->tables.hash)}};
  }

  std::string refuse(const Contestant& mouse) const override { return refuse_to_drive({&mouse, 1}); }
  std::string refuse(const Maze& maze) const override { return refuse_to_drive_in(maze); }
  Settings settings(const Contestant& mouse) const override { return settings_in_seconds(mouse); }

  std::string_view unit() const override { return "s"; }

  MazeFacts facts(const Maze& maze) const override {
    const DriveBound bound = drive_bound_of(maze, rules_, *model_);
    return {bound.score ? std::optional(in_seconds(*bound.score)) : std::nullopt,
            {or_none(bound.fastest), or_none(bound.score)},
            Prepared{bound, reachable_cells(maze)}};
  }

  Held hold(const Race& race, ContestResult& result, Keep keep, const std::atomic<bool>* stop) const override {
    const Contestant& mouse = race.mice[result.mouse];
    const NamedMaze& maze = race.mazes[result.maze];
    const auto& prepared = std::any_cast<const Prepared&>(race.facts[result.maze].prepared);
    const auto mind = mouse.drive(maze.maze, brief(maze.maze, rules_, *model_, result.seed));
    Stoppable stoppable(*mind, stop);
    DriveRecord record = drive(maze.maze, rules_, *model_, stoppable);
    const bool interrupted = record.reason == ForfeitReason::interrupted;
    if (interrupted && !keep.record && !keep.picture) return {};
    const DriveScore score = labmouse::score(record, rules_);
    result.outcome = outcome_of(record, score);
    result.figures = figures_of(record, score, prepared.bound, coverage_of(record, maze.maze, prepared.reachable),
                                mind->last_words());
    if (!mind->started()) result.never_started = mind->last_words().substr(0, mind->last_words().find('\n'));
    if (score.value() && best_of(score)) add_score(*score.value(), prepared.bound, rules_, result);
    result.done = !interrupted;
    return kept(mouse, maze, result.seed, std::move(record), keep);
  }

  double limit_score() const override { return in_seconds(rules_.time_limit); }
  std::string_view tie_breaker() const override { return "search_us"; }
  ScorePlace score_place() const override { return {"score", "value", 1e-6, -in_seconds(rules_.untouched_bonus)}; }
  const WorldFields& fields() const override { return seconds_fields(); }
  std::string_view why_no_bound() const override { return "in which no mouse could score"; }

  std::string notes(const Race& race) const override {
    return fmt::format(
        "Rules {}: {}. Lower is better; mice that scored in more contests come first.\nRobot {}, cells of {:g} mm. "
        "Search ends when the first fast run begins; best runs are timed from rest to the centre.\nBound, {} s on "
        "average: the fastest route, driven by a mouse that knows the maze but must first search a way there.\n",
        shown(rules_.name), formula(), shown(model_->robot.name), model_->tables.cell,
        columns::number(mean_bound(race), 3));
  }

 private:
  Held kept(const Contestant& mouse, const NamedMaze& maze, std::uint64_t seed, DriveRecord record, Keep keep) const {
    Held held;
    if (keep.record || keep.picture) {
      const DriveRecordFile file = drive_record_file_of(mouse, maze, rules_, model_, seed, record);
      if (keep.record) held.record = write_drive_record(file);
      if (keep.picture) held.picture = draw_contest(file);
    }
    held.run = std::move(record);
    return held;
  }

  DriveRules rules_;
  std::shared_ptr<const DriveModel> model_;
};

}  // namespace

std::shared_ptr<const World> seconds_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model) {
  return std::make_shared<SecondsWorld>(rules, std::move(model));
}

DriveRecordFile drive_record_file_of(const Contestant& mouse, const NamedMaze& maze, const DriveRules& rules,
                                     std::shared_ptr<const DriveModel> model, std::uint64_t seed, DriveRecord record) {
  DriveRecordFile file;
  file.maze_name = maze.name;
  file.maze = maze.maze;
  file.mouse = mouse.name;
  file.spec = mouse.spec;
  file.settings = settings_in_seconds(mouse);
  file.seed = seed;
  file.tables_hash = model->tables.hash;
  file.model = std::move(model);
  file.rules = rules;
  file.record = std::move(record);
  const DriveScore scored = score(file.record, rules);
  if (scored.best) file.recorded_score = scored.runs[*scored.best];
  return file;
}

}  // namespace labmouse
