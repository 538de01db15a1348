#include "labmouse/lab/steps/steps_world.hpp"

#include <fmt/format.h>

#include <chrono>

#include "labmouse/contest/action_errors.hpp"
#include "labmouse/contest/coverage.hpp"
#include "labmouse/contest/score.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/mice/stoppable.hpp"
#include "labmouse/lab/steps/steps_fields.hpp"
#include "labmouse/lab/steps/steps_figures.hpp"
#include "labmouse/lab/steps/steps_files.hpp"
#include "labmouse/lab/steps/steps_notes.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/maze/routes.hpp"
#include "labmouse/mouse/forwarding_strategy.hpp"

namespace labmouse {
namespace {

/// A mouse with a stopwatch, which strategies themselves may not have.
class Timed final : public ForwardingStrategy {
 public:
  using ForwardingStrategy::ForwardingStrategy;

  Action decide(const Sighting& seen) override {
    const auto begin = std::chrono::steady_clock::now();
    const Action action = mouse().decide(seen);
    spent_ += std::chrono::steady_clock::now() - begin;
    return action;
  }
  double measured() const { return std::chrono::duration<double, std::micro>(spent_).count(); }

 private:
  std::chrono::steady_clock::duration spent_{};
};

/// Runs a contest, or takes the one that was run before.
PlayedContest contest_of(const Contestant& mouse, const NamedMaze& maze, const Rules& rules, std::uint64_t seed,
                         bool reasons, const std::atomic<bool>* stop) {
  if (const auto* played = std::get_if<PlayedContests>(&mouse.kind)) return played->at({maze.name, seed});
  Briefing briefing = brief(maze.maze, rules, seed);
  briefing.reasons = reasons;
  const auto strategy = mouse.strategy(maze.maze, briefing);
  Stoppable stoppable(*strategy, stop);
  Timed timed(stoppable);
  RunRecord record = run(maze.maze, rules, timed);
  const StrategyReport report = strategy->report();
  return {std::move(record), report.started, report.microseconds.value_or(timed.measured())};
}

ForfeitReason reason_of(const RunRecord& record) {
  return record.outcome == Outcome::forfeit ? record.steps.back().action.reason : ForfeitReason::none;
}

std::string outcome_of(const RunRecord& record) {
  const std::string outcome(name_of(record.outcome));
  return record.outcome == Outcome::forfeit ? fmt::format("{}: {}", outcome, name_of(reason_of(record))) : outcome;
}

LeftOut<JsonText> counts_of(const RunRecord& record) {
  if (record.counts.empty()) return {};
  Json json;
  for (const Count& count : record.counts) json[count.name] = count.value;
  return JsonText{json.dump()};
}

std::int64_t first_of(const ActionErrors& action_errors) {
  int first = 0;
  for (const ActionErrorCount& count :
       {action_errors.blocked, action_errors.void_rotations, action_errors.cut_movements, action_errors.idle_resets})
    if (count.first > 0 && (first == 0 || count.first < first)) first = count.first;
  return first;
}

std::shared_ptr<const Figures> figures_of(const RunRecord& record, const Score& score, const Coverage& coverage,
                                          const ActionErrors& action_errors, double microseconds) {
  auto figures = std::make_shared<StepsFigures>();
  figures->search_steps = score.search_steps;
  if (score.value) figures->speed_steps = score.speed_steps;
  figures->discovered = coverage.discovered;
  figures->visited = coverage.visited;
  if (action_errors != ActionErrors()) {
    figures->blocked_steps = action_errors.blocked.steps;
    figures->void_rotations = action_errors.void_rotations.steps;
    figures->cut_movements = action_errors.cut_movements.steps;
    figures->idle_resets = action_errors.idle_resets.steps;
  }
  figures->first_action_error = first_of(action_errors);
  if (!record.last_words.empty()) figures->words = record.last_words;
  figures->counts = counts_of(record);
  figures->decisions = static_cast<std::int64_t>(record.steps.size());
  figures->microseconds = {microseconds};
  return figures;
}

WorldTraits traits_of(const Rules& rules) {
  return {.name = "steps",
          .formula = fmt::format("speed-run steps + search steps / {}", rules.search_factor),
          .conditions = conditions_of(steps_rows, rules),
          .fields = &steps_fields(),
          .is_unnamed = true,
          .heading = rules.budget == Rules().budget ? "" : fmt::format(", budget {}", rules.budget),
          .rules_in_steps = rules,
          .unit = "steps",
          .failure_score = rules.failure_score,
          .limit_score = rules.failure_score};
}

class StepsWorld final : public World {
 public:
  explicit StepsWorld(const Rules& rules) : World(traits_of(rules)), rules_(rules) {}

  std::string refuse(const Contestant& mouse) const override { return refuse_to_walk(mouse); }
  Settings settings(const Contestant& mouse) const override { return settings_in_steps(mouse); }

  MazeFacts facts(const Maze& maze) const override {
    const Bound bound = bound_of(maze, rules_);
    return {bound.score, bound.optimum, reachable_cells(maze)};
  }

  ContestOutput hold(const Race& race, ContestResult& result, Keep keep, const std::atomic<bool>* stop) const override {
    const Contestant& mouse = race.mice[result.mouse];
    const NamedMaze& maze = race.mazes[result.maze];
    const MazeFacts& facts = race.facts[result.maze];
    auto [record, started, microseconds] = contest_of(mouse, maze, rules_, result.seed, keep.reasons, stop);
    const bool interrupted = reason_of(record) == ForfeitReason::interrupted;
    if (interrupted && !keep.record && !keep.picture) return {};
    const Score score = labmouse::score(record, rules_);
    result.outcome = outcome_of(record);
    result.outcome_order = static_cast<int>(record.outcome) * 100 + static_cast<int>(reason_of(record));
    if (!started) result.never_started = record.last_words.substr(0, record.last_words.find('\n'));
    if (!started && result.never_started.empty()) result.never_started = result.outcome;
    result.score = score.value;
    result.counted = score.value.value_or(rules_.failure_score);
    if (score.value && facts.bound) result.ratio = *score.value / *facts.bound;
    result.figures = figures_of(record, score, coverage_of(record, maze.maze.size(), facts.reachable),
                                action_errors_of(record, rules_), microseconds);
    if (reason_of(record) == ForfeitReason::not_judged) leave_unjudged(result);
    result.done = !interrupted;
    return kept(mouse, maze, rules_, result.seed, std::move(record), keep);
  }

  std::string notes(const Race& race) const override { return steps_notes(race, rules_); }
  std::string remarks(const Race& race) const override { return steps_remarks(race); }

 private:
  Rules rules_;
};

}  // namespace

std::shared_ptr<const World> steps_world(const Rules& rules) { return std::make_shared<StepsWorld>(rules); }

}  // namespace labmouse
