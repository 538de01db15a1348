#include "labmouse/lab/studies/sweep.hpp"

#include <algorithm>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

/// Over mazes, as in a leaderboard. One maze says nothing of others: there the interval is over its runs.
std::optional<Interval> interval_of(const Race& race, const Standing& standing) {
  if (standing.mazes > 1) return standing.interval;
  std::vector<double> scores;
  for (const ContestResult& contest : race.results)
    if (counts(race, contest) && contest.counted) scores.push_back(*contest.counted);
  return scores.size() > 1 ? std::optional(bootstrap_interval(scores, race.order.seed)) : std::nullopt;
}

/// The point of a race of one mouse.
SweepPoint point_of(const Race& race, const std::string& value) {
  const Standing standing = standings_of(race).front();
  return {value, standing.runs, standing.runs - standing.solved, standing.mean_all, interval_of(race, standing)};
}

/// The parameter of that name, which the mouse of the SPEC has.
const Parameter& parameter_of(std::string_view spec, std::string_view name) {
  const auto parameters = find_mouse(spec.substr(0, spec.find_first_of(":,")))->parameters;
  return *std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& p) { return p.name == name; });
}

void describe_mazes(const std::vector<NamedMaze>& mazes, Sweep& sweep) {
  for (const NamedMaze& maze : mazes)
    if (sweep.order.world->facts(maze.maze).bound)
      sweep.mazes.push_back(maze.name);
    else
      ++sweep.routeless;
}

}  // namespace

Sweep hold_sweep(std::string_view spec, const Variation& variation, const std::vector<NamedMaze>& mazes,
                 const RaceOrder& order, const SweepHooks& hooks) {
  Sweep sweep;
  sweep.order = order;
  const SpecResult variants = read_variants(spec, variation.parameter, variation.values);
  if (sweep.error = !variation.error.empty() ? variation.error : variants.error; !sweep.error.empty()) return sweep;
  const Parameter& parameter = parameter_of(spec, variation.parameter);
  const std::vector<std::string> usual = {std::string(parameter.default_value)};
  sweep.mouse = read_variants(spec, parameter.name, usual).contestants.front().name;
  sweep.parameter = parameter.name;
  sweep.meaning = parameter.meaning;
  sweep.values = variants.contestants.size();
  describe_mazes(mazes, sweep);

  const std::size_t all = contests_of(variants.contestants, mazes.size(), order);
  RaceHooks race_hooks;
  race_hooks.stop = hooks.stop;
  if (hooks.finished)
    race_hooks.finished = [&](const Race&, const ContestResult&, const Held&) { hooks.finished(all); };
  for (const Contestant& variant : variants.contestants) {
    const Race race = hold_race({variant}, mazes, order, race_hooks);
    // Part of the mazes would make a mean that compares with no other.
    if (race.stopped) break;
    sweep.points.push_back(point_of(race, std::string(variant.settings.choice(parameter.name))));
  }
  return sweep;
}

}  // namespace labmouse
