#include "labmouse/lab/studies/sweep.hpp"

#include <algorithm>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/numbers/maze_interval.hpp"
#include "labmouse/lab/races/never_started.hpp"
#include "labmouse/lab/standings/maze_scores.hpp"
#include "labmouse/lab/standings/standings.hpp"

namespace labmouse {
namespace {

/// The interval over mazes, as in a leaderboard. For a single maze, it is over the runs.
std::optional<Interval> interval_of(const Race& race, const Standing& standing) {
  std::vector<double> scores;
  std::size_t mazes = 0;
  for (const MazeScores& maze : maze_scores(race, standing.mouse)) mazes += maze.contests > 0 ? 1 : 0;
  if (mazes > 1) return standing.interval_at_limit;
  const double limit = race.world().traits().limit_score;
  for (const ContestResult& contest : race.results)
    if (counts(race, contest)) scores.push_back(contest.counted.value_or(limit));
  if (scores.size() < 2) return std::nullopt;
  const Interval found = mean_interval(scores, race.order.seed);
  return including(among_scores(found, race.world().traits().score_place), *standing.mean_at_limit);
}

/// The point of a sweep from the race of one mouse.
SweepPoint point_of(const Race& race, const std::string& value) {
  const Standing standing = standings_of(race).front();
  return {value,
          standing.runs,
          standing.runs - standing.finished,
          standing.mean_at_limit,
          interval_of(race, standing),
          standing.mean_finished};
}

/// The built-in mouse that has the parameter; null if it is one of a program, which only the program knows.
const BuiltinMouse* owner_of(std::string_view parameter, const Contestant& variant) {
  const BuiltinMouse* entry = entry_of(variant);
  const auto is_it = [&](const Setting& setting) { return setting.name == parameter; };
  const auto& settings = variant.settings.all();
  return variant.parts && std::none_of(settings.begin(), settings.end(), is_it) ? nullptr : entry;
}

/// Sets the mouse and the meaning of the parameter.
void describe_parameter(std::string_view spec, const BuiltinMouse* mouse, Sweep& sweep) {
  sweep.mouse = spec;
  if (mouse == nullptr) return;
  const auto parameters = mouse->parameters;
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& parameter) { return parameter.name == sweep.parameter; });
  const std::string usual(found->default_value);
  sweep.mouse = read_variants(spec, sweep.parameter, {&usual, 1}).contestants.front().name;
  sweep.meaning = found->meaning;
}

/// The values of the variants, in their canonical form for built-in mice.
std::vector<std::string> values_of(const SweptValues& swept, const std::vector<Contestant>& variants) {
  std::vector<std::string> values;
  if (owner_of(swept.parameter, variants.front()) == nullptr) {
    for (const std::string& value : swept.values)
      if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  } else {
    for (const Contestant& variant : variants) values.emplace_back(variant.settings.choice(swept.parameter));
  }
  return values;
}

void describe_mazes(const std::vector<NamedMaze>& mazes, Sweep& sweep) {
  for (const NamedMaze& maze : mazes)
    if (sweep.order.world->facts(maze.maze).bound)
      sweep.mazes.push_back(maze.name);
    else
      ++sweep.routeless;
}

/// One value: the mouse and the world that have it.
struct SweptRace {
  std::string value;
  Contestant mouse;
  std::shared_ptr<const World> world;
};

/// Races the swept one after the other and adds their points.
void race_all(const std::vector<SweptRace>& swept, const std::vector<NamedMaze>& mazes, const SweepHooks& hooks,
              Sweep& sweep) {
  sweep.values = swept.size();
  describe_mazes(mazes, sweep);
  std::size_t all = 0;
  RaceOrder order = sweep.order;
  for (const SweptRace& each : swept) {
    order.world = each.world;
    all += contests_of({each.mouse}, mazes.size(), order);
  }
  RaceHooks race_hooks;
  race_hooks.stop = hooks.stop;
  if (hooks.finished)
    race_hooks.finished = [&](const Race&, const ContestResult&, const ContestOutput&) { hooks.finished(all); };
  std::vector<MazeScores> first;
  for (const SweptRace& each : swept) {
    order.world = each.world;
    const Race race = hold_race({each.mouse}, mazes, order, race_hooks);
    // An incomplete race would give a mean over other mazes.
    if (race.stopped) break;
    SweepPoint& point = sweep.points.emplace_back(point_of(race, each.value));
    sweep.never_started += never_started_lines(race);
    if (sweep.robot.empty()) continue;
    std::vector<MazeScores> scores = maze_scores(race, 0);
    // Only the scores are compared, as in compare_robots().
    if (!first.empty()) point.against_first = pair_of(scores, first, false, order.seed);
    if (first.empty()) first = std::move(scores);
  }
}

}  // namespace

Sweep hold_sweep(std::string_view spec, const SweptValues& chosen, const std::vector<NamedMaze>& mazes,
                 const RaceOrder& order, const SweepHooks& hooks, const ExternalOptions& external_mice) {
  Sweep sweep;
  sweep.order = order;
  sweep.parameter = chosen.parameter;
  const SpecResult variants = read_variants(spec, chosen.parameter, chosen.values, external_mice);
  if (sweep.error = !chosen.error.empty() ? chosen.error : variants.error; !sweep.error.empty()) return sweep;
  const std::vector<std::string> values = values_of(chosen, variants.contestants);
  describe_parameter(spec, owner_of(chosen.parameter, variants.contestants.front()), sweep);
  std::vector<SweptRace> swept;
  for (std::size_t i = 0; i < values.size(); ++i) swept.push_back({values[i], variants.contestants[i], order.world});
  race_all(swept, mazes, hooks, sweep);
  return sweep;
}

Sweep hold_robot_sweep(const Contestant& mouse, const RobotVariants& robots, const std::vector<NamedMaze>& mazes,
                       const RaceOrder& order, const SweepHooks& hooks) {
  Sweep sweep;
  sweep.order = order;
  sweep.mouse = mouse.name;
  sweep.robot = robots.robot;
  sweep.parameter = robots.key;
  sweep.meaning = robots.meaning;
  if (sweep.error = robots.error; !sweep.error.empty()) return sweep;
  std::vector<SweptRace> swept;
  for (std::size_t i = 0; i < robots.values.size(); ++i) swept.push_back({robots.values[i], mouse, robots.worlds[i]});
  race_all(swept, mazes, hooks, sweep);
  return sweep;
}

}  // namespace labmouse
