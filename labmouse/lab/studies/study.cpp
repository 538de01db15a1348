#include "labmouse/lab/studies/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "labmouse/lab/standings/maze_scores.hpp"

namespace labmouse {
namespace {

/// Why the folds cannot be made of these mazes; empty where they can.
std::string complaint(const Study& study, std::size_t given) {
  const std::size_t mazes = study.selection.mazes.size();
  const int folds = study.order.folds;
  if (folds < 2) return fmt::format("{} folds are too few; use at least 2", folds);
  if (mazes >= static_cast<std::size_t>(folds)) return "";
  const std::string counted =
      fmt::format("{} different {} with a route (of {} given)", mazes, mazes == 1 ? "maze" : "mazes", given);
  if (mazes < 2) return counted + "; a study needs at least 2";
  return fmt::format("{} are too few for {} folds; use at most {} folds, or more mazes", counted, folds, mazes);
}

bool stopping(const StudyHooks& hooks) { return hooks.stop != nullptr && hooks.stop->load(); }

std::size_t contests_of(const std::vector<Contestant>& mice, const Study& study) {
  return labmouse::contests_of(mice, study.selection.mazes.size(), study.order.race);
}

/// The mice for a fold: learning mice are trained on the mazes of the other folds.
std::vector<Contestant> taught(const std::vector<Contestant>& mice, const Study& study, const std::vector<int>& deal,
                               int fold, const StudyHooks& hooks) {
  std::vector<const Maze*> training;
  for (std::size_t maze = 0; maze < deal.size(); ++maze)
    if (deal[maze] != fold) training.push_back(&study.selection.mazes[maze].maze);
  std::vector<Contestant> pupils;
  for (const Contestant& mouse : mice) {
    const bool learns = mouse.taught && study.order.learning && !stopping(hooks);
    pupils.push_back(
        learns ? mouse.taught(training, study.order.race.world->traits().rules_in_steps.value_or(Rules()), hooks.stop)
               : mouse);
    // A race sorts its mice by name; the same names keep the order equal in all folds.
    pupils.back().name = mouse.name;
  }
  return pupils;
}

std::vector<NamedMaze> held_out(const Study& study, const std::vector<int>& deal, int fold) {
  std::vector<NamedMaze> mazes;
  for (std::size_t maze = 0; maze < deal.size(); ++maze)
    if (deal[maze] == fold) mazes.push_back(study.selection.mazes[maze]);
  return mazes;
}

/// Joins the races of the completed folds. Mazes are sorted by name both in the selection and in each race, so the next
/// maze of a fold is the next one of its race.
void join(std::vector<Race> races, const std::vector<int>& deal, Study& study) {
  Race& joined = study.race;
  std::vector<std::vector<std::size_t>> places(races.size());
  for (const int fold : deal) {
    const auto from = static_cast<std::size_t>(fold);
    if (from >= races.size()) continue;
    const std::size_t position = places[from].size();
    places[from].push_back(joined.mazes.size());
    joined.mazes.push_back(races[from].mazes[position]);
    joined.facts.push_back(races[from].facts[position]);
    study.fold_of.push_back(fold);
  }
  for (std::size_t fold = 0; fold < races.size(); ++fold)
    for (ContestResult& contest : races[fold].results) {
      contest.maze = places[fold][contest.maze];
      joined.results.push_back(std::move(contest));
    }
  std::stable_sort(joined.results.begin(), joined.results.end(), [](const ContestResult& a, const ContestResult& b) {
    return std::tie(a.mouse, a.maze, a.run) < std::tie(b.mouse, b.maze, b.run);
  });
}

/// The study before anything is raced.
Study planned(const std::vector<Contestant>& mice, std::vector<NamedMaze> mazes, const StudyOrder& order) {
  Study study;
  study.order = order;
  for (const Contestant& mouse : mice) {
    study.mice.push_back(mouse.name);
    if (mouse.taught) study.learners.push_back(mouse.name);
  }
  study.race.order = order.race;
  study.race.mice = mice;
  std::sort(study.race.mice.begin(), study.race.mice.end(),
            [](const Contestant& a, const Contestant& b) { return a.name < b.name; });
  const std::size_t given = mazes.size();
  study.selection = select_mazes(std::move(mazes), *order.race.world);
  study.error = complaint(study, given);
  return study;
}

/// The fold of each selected maze.
std::vector<int> deal_of(const Study& study) {
  std::vector<std::string> names;
  for (const NamedMaze& maze : study.selection.mazes) names.push_back(maze.name);
  return deal_folds(names, study.order.folds, study.order.race.seed);
}

Comparison compare(const Study& study, const std::string& mouse, const std::string& against) {
  Comparison comparison;
  comparison.mouse = position_of(study.race, mouse);
  comparison.against = position_of(study.race, against);
  comparison.pair = pair_of(maze_scores(study.race, comparison.mouse), maze_scores(study.race, comparison.against),
                            !study.order.race.world->traits().failure_score, study.order.race.seed);
  return comparison;
}

}  // namespace

Study hold_study(const std::vector<Contestant>& mice, std::vector<NamedMaze> mazes, const StudyOrder& order,
                 const StudyHooks& hooks) {
  Study study = planned(mice, std::move(mazes), order);
  if (!study.error.empty()) return study;
  const std::vector<int> deal = deal_of(study);
  for (int fold = 0; fold < order.folds; ++fold)
    study.fold_sizes.push_back(static_cast<std::size_t>(std::count(deal.begin(), deal.end(), fold)));
  const std::size_t all = contests_of(mice, study);
  RaceHooks race_hooks;
  race_hooks.stop = hooks.stop;
  if (hooks.finished)
    race_hooks.finished = [&](const Race&, const ContestResult&, const ContestOutput&) { hooks.finished(all); };
  std::vector<Race> races;
  for (int fold = 0; fold < order.folds; ++fold) {
    std::vector<Contestant> pupils = taught(mice, study, deal, fold, hooks);
    if (stopping(hooks)) break;
    Race race = hold_race(std::move(pupils), held_out(study, deal, fold), order.race, race_hooks);
    // An incomplete fold would count some mazes for some mice only.
    if (race.stopped) break;
    races.push_back(std::move(race));
  }
  study.folds_done = static_cast<int>(races.size());
  study.race.stopped = study.folds_done < order.folds;
  join(std::move(races), deal, study);
  return study;
}

std::size_t position_of(const Race& race, const std::string& mouse) {
  const auto found = std::find_if(race.mice.begin(), race.mice.end(),
                                  [&](const Contestant& contestant) { return contestant.name == mouse; });
  return static_cast<std::size_t>(found - race.mice.begin());
}

std::vector<MousePair> pairs_of(const std::vector<Comparison>& comparisons) {
  std::vector<MousePair> pairs;
  for (const Comparison& comparison : comparisons) pairs.push_back(comparison.pair);
  return pairs;
}

std::vector<Comparison> comparisons_of(const Study& study) {
  std::vector<Comparison> comparisons;
  const bool all = study.mice.size() <= most_in_all_pairs;
  for (std::size_t i = 1; i < study.mice.size(); ++i)
    for (std::size_t j = 0; j < (all ? i : 1); ++j) comparisons.push_back(compare(study, study.mice[i], study.mice[j]));
  const std::vector<PairVerdicts> verdicts = verdicts_of(pairs_of(comparisons));
  for (std::size_t i = 0; i < comparisons.size(); ++i) comparisons[i].verdicts = verdicts[i];
  return comparisons;
}

}  // namespace labmouse
