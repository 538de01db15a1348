#include "labmouse/lab/physical/physical_world.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/contest/code_contest.hpp"
#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/drive_coverage.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/contest/fallible.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/lab/bounds/drive_bound.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/mice/stoppable.hpp"
#include "labmouse/lab/physical/physical_fields.hpp"
#include "labmouse/lab/pictures/drive_picture.hpp"
#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/robots/robot_json.hpp"
#include "labmouse/lab/seconds/drive_results.hpp"
#include "labmouse/lab/seconds/seconds_world.hpp"
#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/maze/routes.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {
namespace {

/// A point of the trace so often: every 20 mm at 400 mm/s.
constexpr int trace_ticks = 50;

/// What is found out about a maze once.
struct Prepared {
  DriveBound bound;
  CellSet reachable;
};

std::int64_t ends_of(const PhysicalRecord& record, RunEnd end) {
  return std::count(record.ends.begin(), record.ends.end(), end);
}

/// Runs from the start that came to their end.
std::int64_t done_runs(const PhysicalRecord& record) {
  std::int64_t done = 0;
  for (std::size_t i = 0; i < record.ends.size(); ++i)
    if (record.ends[i] == RunEnd::done && record.drive.runs[i].kind != DriveRun::Kind::home) ++done;
  return done;
}

/// What ended a contest without a score.
RunEnd end_of(const PhysicalRecord& record) {
  if (record.drive.outcome == DriveOutcome::forfeit)
    return record.drive.reason == ForfeitReason::no_way ? RunEnd::walled_in : RunEnd::given_up;
  for (auto end = record.ends.rbegin(); end != record.ends.rend(); ++end)
    if (*end != RunEnd::done) return *end;
  return RunEnd::out_of_time;
}

/// In the order of PhysicalFigure. Of a mouse that does not tell what it knows there is no coverage, and nobody can say
/// what it takes walls for.
std::vector<Value> figures_of(const PhysicalRecord& record, const DriveScore& score, const DriveBound& bound,
                              const DriveRules& rules, const std::optional<Coverage>& coverage,
                              std::string_view words) {
  const auto if_told = [&](std::int64_t count) { return coverage ? Value(count) : Value(nullptr); };
  const auto best = best_of(score);
  const DriveRunScore* counting = score.best ? &score.runs[*score.best] : nullptr;
  const auto grazes =
      std::count_if(record.touches.begin(), record.touches.end(), [](const WallTouch& touch) { return !touch.crash; });
  return {score.best ? Value(JsonText{score_json(score).dump()}) : Value(nullptr),
          std::int64_t{search_time_of(record.drive)},
          or_none(best),
          or_none(excess_of(best, bound)),
          std::int64_t{starts_of(record.drive)},
          done_runs(record),
          ends_of(record, RunEnd::slid),
          ends_of(record, RunEnd::strayed),
          if_told(ends_of(record, RunEnd::misread)),
          if_told(ends_of(record, RunEnd::walled_in)),
          ends_of(record, RunEnd::out_of_time),
          std::int64_t{record.carried},
          std::int64_t{grazes},
          if_told(record.misreads),
          if_told(record.contradictions),
          record.frailty,
          in_seconds(score.value().value_or(rules.time_limit)),
          std::int64_t{record.drive.decisions},
          std::int64_t{record.drive.replanned},
          coverage ? Value(coverage->discovered) : Value(nullptr),
          coverage ? Value(coverage->visited) : Value(nullptr),
          score.best ? Value(nullptr) : Value(std::string(name_of(end_of(record)))),
          words.empty() ? Value() : Value(std::string(words)),
          or_none(score.value()),
          counting != nullptr ? or_none(counting->gate_to_gate) : Value(nullptr),
          counting != nullptr ? or_none(counting->rest_to_centre) : Value(nullptr)};
}

class PhysicalWorld : public World {
 public:
  PhysicalWorld(const DriveRules& rules, std::shared_ptr<const DriveModel> model, const PhysicalConditions& conditions)
      : rules_(rules), model_(sharing_tables(std::move(model))), conditions_(conditions) {}

  std::string_view name() const override { return "physical"; }
  std::string formula() const override { return formula_of(rules_); }
  std::vector<Condition> conditions() const override {
    return {{"rules", JsonText{rules_json(rules_).dump()}},
            {"robot", JsonText{robot_json(model_->robot, RobotParts::with_body).dump()}},
            {"tables", hash_text(model_->tables.hash)},
            {"noise", conditions_.noise.all},
            {"spread", conditions_.noise.spread},
            {"search_speed", conditions_.pilot.search_speed},
            {"pace", conditions_.pilot.pace},
            {"map", std::string(name_of(conditions_.map))}};
  }
  int edition() const override { return physical_edition; }
  std::string heading() const override { return ", " + noise_text(); }

  std::string refuse(const Contestant& mouse) const override {
    return mouse.pilot ? "" : refuse_to_drive({&mouse, 1}, Driving::with_errors);
  }
  std::string refuse(const Maze& maze) const override { return refuse_to_drive_in(maze); }
  Settings settings(const Contestant& mouse) const override { return settings_in_seconds(mouse); }

  std::string_view unit() const override { return "s"; }
  bool throws_dice() const override { return true; }
  // Each takes a thousand times as long as one in seconds.

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
    PhysicalConditions conditions = conditions_;
    conditions.trace_every = keep.record || keep.picture ? trace_ticks : 0;
    Driven driven = mouse.pilot ? drive_itself(mouse, maze.maze, conditions, result)
                                : drive_by_mind(mouse, maze.maze, conditions, result.seed, prepared.reachable, stop);
    PhysicalRecord& record = driven.record;
    const bool interrupted = record.drive.reason == ForfeitReason::interrupted;
    if (interrupted && !keep.record && !keep.picture) return {};
    const DriveScore score = labmouse::score(record.drive, rules_);
    result.outcome = outcome_of(record.drive, score);
    result.figures = figures_of(record, score, prepared.bound, rules_, driven.coverage, driven.words);
    if (!driven.started) result.never_started = driven.words.substr(0, driven.words.find('\n'));
    if (score.value()) add_score(*score.value(), prepared.bound, rules_, result);
    if (record.drive.reason == ForfeitReason::not_judged) leave_unjudged(result);
    result.done = !interrupted;
    return kept(mouse, maze, result.seed, conditions, std::move(record), keep);
  }

  double limit_score() const override { return in_seconds(rules_.time_limit); }
  std::string_view tie_breaker() const override { return "search_us"; }
  ScorePlace score_place() const override { return {"score", "value", 1e-6, -in_seconds(rules_.untouched_bonus)}; }
  const WorldFields& fields() const override { return physical_fields(); }
  std::string_view why_no_bound() const override { return "in which no mouse could score"; }

  std::string notes(const Race& race) const override {
    return fmt::format(
        "Rules {}: {}. Lower is better; mice that scored in more contests come first.\nRobot {}, cells of {:g} mm, "
        "{}. The score is the mean of those that scored; 'penalised' counts the others as {:g} s.\nCrashes: the "
        "tyres "
        "slid, the mouse strayed from where it believed to be, or it drove into a wall that it had misread.\nBound, {} "
        "s "
        "on average: a mouse that never errs and knows the maze but must first search a way there.\n",
        shown(rules_.name), formula(), shown(model_->robot.name), model_->tables.cell, noise_text(),
        in_seconds(rules_.time_limit), columns::number(mean_bound(race), 3));
  }

 protected:
  /// What a record of this world has besides.
  virtual void complete(PhysicalPart&) const {}
  /// The contest of a mouse that decides.
  virtual PhysicalRecord contest_of(const Maze& maze, const PhysicalConditions& conditions, std::uint64_t seed,
                                    Strategy& mouse) const {
    return drive_physically(maze, rules_, *model_, conditions, seed, mouse);
  }

  const DriveRules& rules() const { return rules_; }
  const DriveModel& model() const { return *model_; }

 private:
  /// "noise 1 was measured" holds of one mouse; how far mice are apart is a guess that belongs beside it.
  std::string noise_text() const {
    return fmt::format("noise {:g}, spread {:g}", conditions_.noise.all, conditions_.noise.spread);
  }
  /// A contest as it was held.
  struct Driven {
    PhysicalRecord record;
    std::optional<Coverage> coverage;  ///< nothing of a mouse that does not tell what it knows
    std::string words;
    bool started = true;
  };

  Driven drive_by_mind(const Contestant& mouse, const Maze& maze, PhysicalConditions& conditions, std::uint64_t seed,
                       const CellSet& reachable, const std::atomic<bool>* stop) const {
    Briefing briefing = brief(maze, rules_, *model_, seed);
    briefing.sight = 1;
    briefing.drive.pace = conditions.pilot.pace;
    const auto mind = mouse.drive(maze, briefing);
    conditions.map = mind->map_kind().value_or(conditions.map);
    Driven driven;
    Stoppable stoppable(*mind, stop);
    driven.record = contest_of(maze, conditions, seed, stoppable);
    driven.coverage = coverage_of(driven.record.drive, maze, reachable);
    driven.words = mind->last_words();
    driven.started = mind->started();
    return driven;
  }

  Driven drive_itself(const Contestant& mouse, const Maze& maze, const PhysicalConditions& conditions,
                      const ContestResult& contest) const {
    const auto code = mouse.pilot(pilot_briefing(maze, rules_, *model_, conditions, contest.told));
    Driven driven;
    driven.record = drive_by_code(maze, rules_, *model_, conditions, contest.seed, *code);
    driven.words = code->last_words();
    driven.started = code->started();
    return driven;
  }

  Held kept(const Contestant& mouse, const NamedMaze& maze, std::uint64_t seed, const PhysicalConditions& conditions,
            PhysicalRecord record, Keep keep) const {
    Held held;
    if (keep.record || keep.picture) {
      DriveRecordFile file = drive_record_file_of(mouse, maze, rules_, model_, seed, record.drive);
      file.physical = PhysicalPart{conditions, static_cast<const PhysicalNotes&>(record), edition(), "", ""};
      complete(*file.physical);
      if (keep.record) held.record = write_drive_record(file);
      if (keep.picture) held.picture = draw_contest(file);
    }
    held.run = std::move(record);
    return held;
  }

  DriveRules rules_;
  std::shared_ptr<const DriveModel> model_;
  PhysicalConditions conditions_;
};

/// The same by dice.
class FallibleWorld final : public PhysicalWorld {
 public:
  FallibleWorld(const DriveRules& rules, std::shared_ptr<const DriveModel> model, const PhysicalConditions& conditions,
                const HazardFile& hazards)
      : PhysicalWorld(rules, std::move(model), conditions),
        hazards_name_(hazards.name),
        hazards_hash_(hazards.hash),
        hazards_(hazards_of(hazards)) {}

  std::string_view name() const override { return "fallible"; }
  std::vector<Condition> conditions() const override {
    std::vector<Condition> all = PhysicalWorld::conditions();
    all.push_back({"hazards", hazards_name_});
    all.push_back({"hazards_hash", hazards_hash_});
    return all;
  }
  int edition() const override { return fallible_edition; }
  std::string refuse(const Contestant& mouse) const override {
    return refuse_to_drive({&mouse, 1}, Driving::with_errors);
  }

 private:
  PhysicalRecord contest_of(const Maze& maze, const PhysicalConditions& conditions, std::uint64_t seed,
                            Strategy& mouse) const override {
    return drive_fallibly(maze, rules(), model(), conditions, hazards_, seed, mouse);
  }

  void complete(PhysicalPart& part) const override {
    part.hazards = hazards_name_;
    part.hazards_hash = hazards_hash_;
  }

  std::string hazards_name_, hazards_hash_;
  Hazards hazards_;
};

}  // namespace

std::shared_ptr<const World> fallible_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model,
                                            const PhysicalConditions& conditions, const HazardFile& hazards) {
  return std::make_shared<FallibleWorld>(rules, std::move(model), conditions, hazards);
}

std::shared_ptr<const World> physical_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model,
                                            const PhysicalConditions& conditions) {
  return std::make_shared<PhysicalWorld>(rules, std::move(model), conditions);
}

}  // namespace labmouse
