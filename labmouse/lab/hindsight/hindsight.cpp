#include "labmouse/lab/hindsight/hindsight.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "labmouse/chance/rng.hpp"
#include "labmouse/contest/score.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/numbers/statistics.hpp"
#include "labmouse/lab/races/never_started.hpp"
#include "labmouse/lab/steps/steps_world.hpp"
#include "labmouse/lab/studies/parameter_range.hpp"
#include "labmouse/mouse/distance.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

/// Whether step i of the search run ended in a goal.
bool ends_in_goal(const RunRecord& record, std::size_t i, const Maze& maze) {
  if (record.steps[i].action.kind != Action::Kind::step) return false;
  return maze.is_goal(i + 1 < record.steps.size() ? record.steps[i + 1].pose.cell : record.end.cell);
}

/// A uniform random number from -1 to 1, a multiple of 1e-6.
double throw_between(Rng& rng) { return (rng.below(2'000'001) - 1'000'000) / 1e6; }

Setting shifted(const Parameter& parameter, double value, Rng& rng) {
  const double most = std::max(0.25 * std::abs(value), 0.01 * (parameter.high - parameter.low));
  const ParameterRange range = {parameter, parameter.low, parameter.high};
  return {std::string(parameter.name), written_value(range, value + most * throw_between(rng))};
}

/// The parameters of a mouse; none if it is not a built-in mouse.
std::span<const Parameter> parameters_of(const Contestant& mouse) {
  const BuiltinMouse* entry = entry_of(mouse);
  return entry == nullptr ? std::span<const Parameter>() : entry->parameters;
}

/// Collects the results of a maze, the mouse's own apart from those of the others.
class Collector {
 public:
  Collector(const Hindsight& hindsight, const Maze& maze) : hindsight_(hindsight), maze_(maze) {}

  /// To be called when a contest is done, because its record is deleted afterwards.
  void note_stop(const Race& race, const ContestResult& contest, const RunRecord& record) {
    if (!is_own(race, contest)) return;
    stops_.resize(std::max(stops_.size(), static_cast<std::size_t>(contest.run) + 1));
    stops_[static_cast<std::size_t>(contest.run)] = best_stop(record, maze_, hindsight_.order.rules);
  }

  MazeHindsight result(const Race& race) const {
    MazeHindsight found;
    found.maze = race.mazes.front().name;
    found.bound = bound_of(maze_, hindsight_.order.rules);
    std::vector<double> own;
    const ContestResult* best = nullptr;
    for (const ContestResult& contest : race.results) {
      if (!contest.counted) continue;
      if (is_own(race, contest)) own.push_back(*contest.counted);
      if (best == nullptr || *contest.counted < *best->counted) best = &contest;
    }
    found.score = mean(own);
    found.best_stop = mean(stops_);
    if (!hindsight_.has_others || best == nullptr) return found;
    found.best_other = *best->counted;
    found.best_mouse = race.mice[best->mouse].name;
    found.best_seed = best->seed;
    return found;
  }

 private:
  bool is_own(const Race& race, const ContestResult& contest) const {
    return race.mice[contest.mouse].name == hindsight_.mouse && contest.run < hindsight_.order.race.runs;
  }

  const Hindsight& hindsight_;
  const Maze& maze_;
  std::vector<double> stops_;  ///< of the mouse's own contests, by run
};

/// The mouse and, where it is deterministic, its perturbed variants.
std::vector<Contestant> all_mice(const Contestant& mouse, const HindsightOrder& order) {
  std::vector<Contestant> mice = {mouse};
  if (mouse.uses_chance || order.others == 0) return mice;
  for (Contestant& other : perturbed(mouse, order.others, order.race.seed)) mice.push_back(std::move(other));
  return mice;
}

bool has_numbers(const Contestant& mouse) {
  const auto parameters = parameters_of(mouse);
  return std::any_of(parameters.begin(), parameters.end(), is_number);
}

/// Runs maze by maze, so that results of complete mazes remain if it is stopped.
void race_all(const Contestant& mouse, const std::vector<NamedMaze>& mazes, const HindsightHooks& hooks,
              Hindsight& hindsight) {
  const std::vector<Contestant> mice = all_mice(mouse, hindsight.order);
  RaceOrder order = hindsight.order.race;
  order.world = steps_world(hindsight.order.rules);
  order.runs = mouse.uses_chance ? order.runs + hindsight.order.others : 1;
  std::vector<const NamedMaze*> with_route;
  for (const NamedMaze& maze : mazes)
    if (bound_of(maze.maze, hindsight.order.rules).score)
      with_route.push_back(&maze);
    else
      hindsight.routeless.push_back(maze.name);
  const std::size_t all = contests_of(mice, with_route.size(), order);
  for (const NamedMaze* maze : with_route) {
    Collector collector(hindsight, maze->maze);
    RaceHooks race_hooks;
    race_hooks.stop = hooks.stop;
    race_hooks.finished = [&](const Race& race, const ContestResult& contest, const ContestOutput& held) {
      collector.note_stop(race, contest, *held.run);
      if (hooks.finished) hooks.finished(all);
    };
    const Race race = hold_race(mice, {*maze}, order, race_hooks);
    if (hindsight.stopped = race.stopped; hindsight.stopped) return;
    hindsight.mazes.push_back(collector.result(race));
    hindsight.never_started = never_started_lines(race);
    // Stops at once, in the first maze, for a program that does not start at all.
    if (!hindsight.never_started.empty()) return;
  }
}

}  // namespace

double best_stop(const RunRecord& record, const Maze& maze, const Rules& rules) {
  Knowledge known(maze.size());
  DistanceField to_goal(maze.size(), strides(rules.stride));
  double best = score(record, rules).value.value_or(rules.failure_score);
  bool entered = false;
  for (std::size_t i = 0; i < record.steps.size() && record.steps[i].run == Run::search_run; ++i) {
    const StepRecord& step = record.steps[i];
    if (!known.learn(step.pose, step.sighting)) break;
    if (entered) {
      to_goal.fill(known.open(), maze.goals());
      // Replaces this step by the reset. Where the start is a goal, the speed run still needs one step.
      const int search_run = static_cast<int>(i) + 1, speed = std::max(1, to_goal.at(maze.start()));
      if (search_run + speed <= rules.budget) best = std::min(best, score_of(search_run, speed, rules));
    }
    entered = entered || ends_in_goal(record, i, maze);
  }
  return best;
}

std::vector<Contestant> perturbed(const Contestant& mouse, int count, std::uint64_t seed) {
  std::vector<Contestant> variants;
  if (!has_numbers(mouse)) return variants;
  for (int number = 0; number < count; ++number) {
    // Each variant has its own seed, so that a larger `count` only appends variants.
    Rng rng(seed_for(seed, "perturbed", static_cast<std::uint64_t>(number)));
    std::vector<Setting> values;
    for (const Parameter& parameter : parameters_of(mouse))
      if (is_number(parameter) && parameter.scope != ParameterScope::seconds)
        values.push_back(shifted(parameter, mouse.settings.real(parameter.name), rng));
    Contestant variant = std::move(read_variant(mouse, values).contestants.front());
    const auto is_same = [&](const Contestant& other) { return spec_of(other) == spec_of(variant); };
    if (!is_same(mouse) && std::none_of(variants.begin(), variants.end(), is_same))
      variants.push_back(std::move(variant));
  }
  return variants;
}

Hindsight look_back(std::string_view spec, const std::vector<NamedMaze>& mazes, const HindsightOrder& order,
                    const HindsightHooks& hooks) {
  Hindsight hindsight;
  hindsight.order = order;
  const SpecResult read = read_specs(spec);
  if (hindsight.error = read.error; !hindsight.error.empty()) return hindsight;
  if (read.contestants.size() != 1) {
    hindsight.error = fmt::format("'{}' names {} mice; name exactly one", spec, read.contestants.size());
    return hindsight;
  }
  const Contestant& mouse = read.contestants.front();
  if (hindsight.error = refuse_to_walk(mouse); !hindsight.error.empty()) {
    hindsight.error += "; hindsight is for mice that race in steps";
    return hindsight;
  }
  hindsight.mouse = mouse.name;
  hindsight.is_stochastic = mouse.uses_chance;
  hindsight.has_others = order.others > 0 && (mouse.uses_chance || has_numbers(mouse));
  race_all(mouse, mazes, hooks, hindsight);
  return hindsight;
}

}  // namespace labmouse
