#include <fmt/format.h>

#include <algorithm>

#include "labmouse/contest/code_contest.hpp"
#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/drive_coverage.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/lab/drive/drive_fields.hpp"
#include "labmouse/lab/drive/drive_results.hpp"
#include "labmouse/lab/drive/drive_world.hpp"
#include "labmouse/lab/drive/drive_worlds.hpp"
#include "labmouse/lab/failure_rates/physical_settings.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/mice/stoppable.hpp"
#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/lab/text/errors_text.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// Ticks between two points of the trace: 20 mm at 400 mm/s.
constexpr int trace_ticks = 50;

std::int64_t ends_of(const PhysicalNotes& notes, RunEnd end) {
  return std::count(notes.ends.begin(), notes.ends.end(), end);
}

/// Runs from the start that came to their end.
std::int64_t done_runs(const DriveRecord& record, const PhysicalNotes& notes) {
  std::int64_t done = 0;
  for (std::size_t i = 0; i < notes.ends.size(); ++i)
    if (notes.ends[i] == RunEnd::done && record.runs[i].kind != DriveRun::Kind::home) ++done;
  return done;
}

/// What ended a contest without a score.
RunEnd end_of(const DriveRecord& record, const PhysicalNotes& notes) {
  if (record.outcome == DriveOutcome::forfeit)
    return record.reason == ForfeitReason::no_route ? RunEnd::no_route_left : RunEnd::given_up;
  for (auto end = notes.ends.rbegin(); end != notes.ends.rend(); ++end)
    if (*end != RunEnd::done) return *end;
  return RunEnd::out_of_time;
}

WorldTraits traits_of(const DriveRules& rules, const DriveModel& model, const PhysicalConditions& conditions) {
  WorldTraits traits = {.name = "physical",
                        .edition = physical_edition,
                        .conditions = drive_conditions(rules, model, RobotParts::with_body),
                        .fields = &physical_fields(),
                        .heading = ", " + text_of(conditions.errors),
                        .is_stochastic = true};
  for (Condition& each : conditions_of(physical_rows, conditions)) traits.conditions.push_back(std::move(each));
  return traits;
}

class PhysicalWorld : public DriveWorld {
 public:
  PhysicalWorld(WorldTraits its, const DriveRules& rules, std::shared_ptr<const DriveModel> model,
                const PhysicalConditions& conditions)
      : DriveWorld(std::move(its), rules, std::move(model)), conditions_(conditions) {}

  std::string refuse(const Contestant& mouse) const override {
    if (std::holds_alternative<ControllerProgram>(mouse.kind))
      return rules().counts == Counted::run
                 ? ""
                 : fmt::format(
                       "'{}' controls motors; rules with counts = \"{}\" are only for mice that this project's "
                       "controller drives: choose other --rules",
                       shown(mouse.name), name_of(rules().counts));
    const std::string reason = refuse_in_laps(mouse);
    return reason.empty() ? refuse_to_drive({&mouse, 1}, Driving::by_controller) : reason;
  }
  using DriveWorld::refuse;

  std::string notes(const Race& race) const override {
    return fmt::format(
        "Rules {}: {}. Lower is better; mice that finished more contests come first.\nRobot {}, cells of {:g} mm, {}. "
        "'score' is the mean of finished contests; 'failures at limit' counts the others as {:g} {}.\nCrashes: the "
        "tyres slipped, the mouse lost its position, or it hit a wall that its map had as open.\n{}\n",
        shown(rules().name), traits().formula, shown(model().robot.name), model().tables.cell,
        text_of(conditions_.errors), traits().limit_score, traits().unit, bound_words(race));
  }

 protected:
  /// Adds what records of a derived world have in addition.
  virtual void complete(PhysicalPart&) const {}
  /// Runs the contest of a strategy, which this project's controller drives.
  virtual PhysicalRecord contest_of(const Maze& maze, const PhysicalConditions& conditions, std::uint64_t seed,
                                    DrivingStrategy& mouse, const ControllerParts& parts) const {
    return drive_physically(maze, rules(), model(), conditions, seed, mouse, parts);
  }

 private:
  DrivenContest drive(const Contestant& mouse, const Maze& maze, const ContestResult& contest, const CellSet& reachable,
                      bool traced, const std::atomic<bool>* stop) const override {
    PhysicalConditions conditions = conditions_;
    conditions.trace_every = traced ? trace_ticks : 0;
    if (const auto* program = std::get_if<ControllerProgram>(&mouse.kind))
      return drive_itself(*program, maze, conditions, contest);
    // The seed of the contest would tell a program in which maze it is.
    const bool is_program = mouse.external && !mouse.parts;
    Briefing briefing = brief(maze, rules(), model(), is_program ? contest.told : contest.seed);
    briefing.sight = 1;
    briefing.drive.pace = conditions.controller.pace;
    const auto strategy = mouse.driving_strategy(maze, briefing);
    conditions.map = strategy->map_kind().value_or(conditions.map);
    StoppableDriver stoppable(*strategy, stop);
    const std::unique_ptr<PartsOwner> program =
        mouse.parts ? mouse.parts(controller_briefing(maze, rules(), model(), conditions, contest.told)) : nullptr;
    DrivenContest driven =
        driven_of(contest_of(maze, conditions, contest.seed, stoppable, program ? program->parts() : ControllerParts()),
                  conditions);
    driven.coverage = coverage_of(driven.record, maze, reachable);
    const StrategyReport report = strategy->report();
    driven.words = program ? program->last_words() : report.last_words;
    driven.started = program ? program->started() : report.started;
    return driven;
  }

  /// Runs the contest of an external controller.
  DrivenContest drive_itself(const ControllerProgram& program, const Maze& maze, const PhysicalConditions& conditions,
                             const ContestResult& contest) const {
    const auto code = program(controller_briefing(maze, rules(), model(), conditions, contest.told));
    DrivenContest driven =
        driven_of(drive_by_code(maze, rules(), model(), conditions, contest.seed, *code), conditions);
    driven.words = code->last_words();
    driven.started = code->started();
    return driven;
  }

  DrivenContest driven_of(PhysicalRecord record, const PhysicalConditions& conditions) const {
    DrivenContest driven;
    driven.record = std::move(record.drive);
    driven.physical =
        PhysicalPart{conditions, std::move(static_cast<PhysicalNotes&>(record)), traits().edition, "", ""};
    complete(*driven.physical);
    return driven;
  }

  /// For an external controller, whose map is unknown, there are no coverage and no wall detection errors.
  std::shared_ptr<DriveFigures> own_figures(const DrivenContest& driven, const DriveScore& score) const override {
    const DriveRecord& record = driven.record;
    const PhysicalNotes& notes = driven.physical->notes;
    auto figures = std::make_shared<PhysicalFigures>();
    figures->done = done_runs(record, notes);
    figures->slid = ends_of(notes, RunEnd::slid);
    figures->position_lost = ends_of(notes, RunEnd::position_lost);
    figures->late = ends_of(notes, RunEnd::out_of_time);
    figures->carried = notes.carried;
    figures->grazes =
        std::count_if(notes.touches.begin(), notes.touches.end(), [](const WallTouch& touch) { return !touch.crash; });
    if (driven.coverage) {
      figures->wall_error = ends_of(notes, RunEnd::wall_error);
      figures->no_route_left = ends_of(notes, RunEnd::no_route_left);
      figures->wrong_walls = notes.wrong_walls;
      figures->contradictions = notes.contradictions;
    }
    figures->severity = notes.severity;
    figures->par1 = score.value() ? in_seconds(*score.value()) : traits().limit_score;
    if (!score.best) figures->ended_by = name_of(end_of(record, notes));
    return figures;
  }

  PhysicalConditions conditions_;
};

/// The failure model: the same contests with random failures in place of body and controller.
class FailureWorld final : public PhysicalWorld {
 public:
  FailureWorld(WorldTraits its, const DriveRules& rules, std::shared_ptr<const DriveModel> model,
               const PhysicalConditions& conditions, const FailureFile& failure_rates)
      : PhysicalWorld(std::move(its), rules, std::move(model), conditions),
        rates_name_(failure_rates.name),
        rates_hash_(failure_rates.hash),
        rates_(rates_of(failure_rates)) {}

  std::string refuse(const Contestant& mouse) const override {
    const std::string reason = refuse_in_laps(mouse);
    return reason.empty() ? refuse_to_drive({&mouse, 1}, Driving::with_errors) : reason;
  }
  using PhysicalWorld::refuse;

 private:
  PhysicalRecord contest_of(const Maze& maze, const PhysicalConditions& conditions, std::uint64_t seed,
                            DrivingStrategy& mouse, const ControllerParts& /*parts*/) const override {
    return drive_with_failures(maze, rules(), model(), conditions, rates_, seed, mouse);
  }

  void complete(PhysicalPart& part) const override {
    part.failure_rates = rates_name_;
    part.rates_hash = rates_hash_;
  }

  std::string rates_name_, rates_hash_;
  FailureRates rates_;
};

}  // namespace

std::shared_ptr<const World> failure_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model,
                                           const PhysicalConditions& conditions, const FailureFile& failure_rates) {
  WorldTraits traits = traits_of(rules, *model, conditions);
  traits.name = "failures";
  traits.edition = failures_edition;
  traits.conditions.push_back({"failure_rates", failure_rates.name});
  traits.conditions.push_back({"failure_rates_hash", failure_rates.hash});
  return std::make_shared<FailureWorld>(std::move(traits), rules, std::move(model), conditions, failure_rates);
}

std::shared_ptr<const World> physical_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model,
                                            const PhysicalConditions& conditions) {
  return std::make_shared<PhysicalWorld>(traits_of(rules, *model, conditions), rules, std::move(model), conditions);
}

}  // namespace labmouse
