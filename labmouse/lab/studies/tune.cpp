#include "labmouse/lab/studies/tune.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/numbers/statistics.hpp"
#include "labmouse/lab/standings/maze_scores.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// The result of one mouse's contests.
struct Measured {
  std::vector<std::optional<double>> by_maze;
  int failures = 0;
};

bool is_complete(const Race& race, std::size_t mouse) {
  return std::all_of(race.results.begin(), race.results.end(),
                     [&](const ContestResult& contest) { return contest.mouse != mouse || contest.done; });
}

Measured measured(const Race& race, std::size_t mouse, Objective objective) {
  Measured result;
  const std::vector<MazeScores> scores = maze_scores(race, mouse);
  for (std::size_t maze = 0; maze < scores.size(); ++maze) {
    std::optional<double>& value = result.by_maze.emplace_back(scores[maze].mean());
    if (value && objective == Objective::ratio) *value /= *race.facts[maze].bound;
    result.failures += scores[maze].contests - scores[maze].finished;
  }
  return result;
}

/// The mean over the mazes that have a value.
double mean_of(const std::vector<std::optional<double>>& by_maze) {
  std::vector<double> values;
  for (const auto& value : by_maze)
    if (value) values.push_back(*value);
  return values.empty() ? std::numeric_limits<double>::infinity() : mean(values);
}

class Tuner {
 public:
  Tuner(Contestant given, const std::vector<NamedMaze>& mazes, const TuneHooks& hooks, Tune& tune)
      : given_(std::move(given)), mazes_(mazes), hooks_(hooks), tune_(tune) {
    race_hooks_.stop = hooks.stop;
    if (hooks.finished)
      race_hooks_.finished = [this](const Race&, const ContestResult&, const ContestOutput&) { hooks_.finished(all_); };
  }

  void search() {
    evaluate({given_}, 0.0);
    Evolution evolution(first_order());
    while (!tune_.stopped && left() > 0) {
      std::vector<UnitPoint> points = evolution.ask();
      points.resize(std::min(points.size(), left()));
      const std::size_t before = tune_.evaluations.size();
      evaluate(candidates_at(points), evolution.step());
      if (tune_.stopped || left() == 0) break;
      std::vector<double> values;
      for (std::size_t i = before; i < tune_.evaluations.size(); ++i) values.push_back(tune_.evaluations[i].value);
      evolution.tell(values);
    }
  }

 private:
  std::size_t left() const { return static_cast<std::size_t>(tune_.order.evaluations) - tune_.evaluations.size(); }

  EvolutionOrder first_order() const {
    EvolutionOrder order;
    for (const ParameterRange& range : tune_.ranges)
      order.start.push_back(share_of(range, given_.settings.real(range.parameter.name)));
    order.step = tune_.order.step;
    order.population = tune_.order.population;
    order.seed = seed_for(tune_.order.race.seed, "tune");
    return order;
  }

  std::vector<Contestant> candidates_at(const std::vector<UnitPoint>& points) const {
    std::vector<Contestant> candidates;
    for (const UnitPoint& point : points) {
      std::vector<Setting> values;
      for (std::size_t i = 0; i < point.size(); ++i)
        values.push_back({std::string(tune_.ranges[i].parameter.name), value_at(tune_.ranges[i], point[i])});
      candidates.push_back(read_variant(given_, values).contestants.front());
    }
    return candidates;
  }

  /// Races a generation, and records in order the candidates whose contests are all done.
  void evaluate(const std::vector<Contestant>& candidates, double step) {
    race(candidates);
    for (const Contestant& candidate : candidates)
      if (const auto found = known_.find(candidate.name); found != known_.end()) note(candidate, found->second, step);
    ++generation_;
    if (hooks_.generation) hooks_.generation(tune_);
  }

  /// Races those of the candidates that were not raced before, each once.
  void race(const std::vector<Contestant>& candidates) {
    std::map<std::string, Contestant> fresh;
    for (const Contestant& candidate : candidates)
      if (!known_.contains(candidate.name)) fresh.emplace(candidate.name, candidate);
    std::vector<Contestant> mice;
    for (auto& [name, mouse] : fresh) mice.push_back(std::move(mouse));
    expect(mice, left() - candidates.size());
    const Race race = hold_race(std::move(mice), mazes_, tune_.order.race, race_hooks_);
    for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse)
      if (is_complete(race, mouse)) known_.emplace(race.mice[mouse].name, measured(race, mouse, tune_.order.objective));
    tune_.stopped = race.stopped || (hooks_.stop != nullptr && hooks_.stop->load() && left() > candidates.size());
  }

  /// Updates the expected number of all contests: those before, those of these mice, and an estimate for `to_come`
  /// later candidates. The estimate takes the number of the mouse as given for each of them.
  void expect(const std::vector<Contestant>& mice, std::size_t to_come) {
    const std::size_t now = contests_of(mice, mazes_.size(), tune_.order.race);
    if (generation_ == 0) of_one_ = now;
    before_ += now;
    all_ = before_ + to_come * of_one_;
  }

  void note(const Contestant& candidate, const Measured& measured, double step) {
    Evaluation evaluation{generation_,     step, candidate.name, {}, mean_of(measured.by_maze), measured.failures,
                          measured.by_maze};
    for (const ParameterRange& range : tune_.ranges)
      evaluation.values.emplace_back(candidate.settings.choice(range.parameter.name));
    tune_.evaluations.push_back(std::move(evaluation));
  }

  Contestant given_;
  const std::vector<NamedMaze>& mazes_;
  const TuneHooks& hooks_;
  Tune& tune_;
  RaceHooks race_hooks_;
  std::map<std::string, Measured> known_;  ///< by their SPECs in the shortest form
  int generation_ = 0;
  std::size_t before_ = 0, of_one_ = 0, all_ = 0;
};

}  // namespace

Tune hold_tune(std::string_view spec, const std::vector<ParameterRange>& ranges, const std::vector<NamedMaze>& mazes,
               const TuneOrder& order, const TuneHooks& hooks) {
  Tune tune;
  tune.order = order;
  tune.ranges = ranges;
  SpecResult mouse = read_variant(spec, {});
  if (tune.error = mouse.error; !tune.error.empty()) return tune;
  if (ranges.empty()) tune.error = "no parameters to tune are named";
  for (const NamedMaze& maze : mazes) {
    const std::optional<double> bound = order.race.world->facts(maze.maze).bound;
    if (bound)
      ++tune.mazes;
    else
      ++tune.routeless;
    if (order.objective == Objective::ratio && bound && *bound <= 0.0)
      tune.error = fmt::format("the best possible score in '{}' is {:g}, so no ratio to it exists: tune the score",
                               shown(maze.name), *bound);
  }
  if (tune.mazes == 0) tune.error = "nothing to tune on: the goal cannot be reached in any of the mazes";
  if (tune.error.empty()) Tuner(std::move(mouse.contestants.front()), mazes, hooks, tune).search();
  return tune;
}

const Evaluation& best_of(const Tune& tune) {
  return *std::min_element(tune.evaluations.begin(), tune.evaluations.end(),
                           [](const Evaluation& a, const Evaluation& b) { return a.value < b.value; });
}

Gain gain_of(const Tune& tune) {
  const auto &given = tune.evaluations.front().by_maze, &best = best_of(tune).by_maze;
  std::vector<double> differences;
  for (std::size_t maze = 0; maze < given.size(); ++maze)
    if (given[maze] && best[maze]) differences.push_back(*best[maze] - *given[maze]);
  const PairedDifference found = paired_difference(differences, tune.order.race.seed);
  Gain gain{found.mean, std::nullopt, found.below, found.equal, found.above};
  if (found.count > 1) gain.interval = found.interval;
  return gain;
}

}  // namespace labmouse
