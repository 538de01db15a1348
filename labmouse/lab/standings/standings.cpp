#include "labmouse/lab/standings/standings.hpp"

#include <algorithm>

namespace labmouse {
namespace {

/// What the solved contests of one mouse add up to.
struct Solved {
  std::vector<double> scores, ratios, exploration, over_optimum;
  int optimal = 0;

  void add(const Score& score, const Bound& bound) {
    scores.push_back(*score.value);
    ratios.push_back(*score.value / *bound.score);
    exploration.push_back(score.exploration_steps);
    over_optimum.push_back(score.speed_steps - *bound.optimum);
    if (score.speed_steps == *bound.optimum) ++optimal;
  }
};

std::optional<double> mean_if_any(std::span<const double> values) {
  return values.empty() ? std::nullopt : std::optional(mean(values));
}

Standing standing_of(const Race& race, std::size_t mouse) {
  Standing standing;
  standing.mouse = mouse;
  Solved solved;
  std::vector<double> all, discovered, visited;
  double microseconds = 0.0;
  long decisions = 0;
  for (const ContestResult& contest : race.results) {
    if (contest.mouse != mouse || !counts(race, contest)) continue;
    all.push_back(penalised(race, contest));
    discovered.push_back(contest.coverage.discovered);
    visited.push_back(contest.coverage.visited);
    microseconds += contest.microseconds;
    decisions += contest.decisions;
    if (contest.score.value) solved.add(contest.score, race.bounds[contest.maze]);
  }
  standing.runs = static_cast<int>(all.size());
  standing.solved = static_cast<int>(solved.scores.size());
  standing.mean_score = mean_if_any(solved.scores);
  standing.mean_ratio = mean_if_any(solved.ratios);
  standing.mean_exploration = mean_if_any(solved.exploration);
  standing.mean_speed_over_optimum = mean_if_any(solved.over_optimum);
  standing.penalised_mean = mean_if_any(all);
  standing.mean_discovered = mean_if_any(discovered);
  standing.mean_visited = mean_if_any(visited);
  std::vector<double> by_maze;
  for (const auto& score : scores_by_maze(race, mouse))
    if (score) by_maze.push_back(*score);
  standing.mazes = static_cast<int>(by_maze.size());
  standing.interval = bootstrap_interval(by_maze, race.order.seed);
  if (!all.empty()) standing.optimal_share = solved.optimal / static_cast<double>(all.size());
  if (decisions > 0) standing.microseconds_per_decision = microseconds / static_cast<double>(decisions);
  return standing;
}

}  // namespace

bool counts(const Race& race, const ContestResult& contest) {
  return contest.done && race.bounds[contest.maze].score.has_value();
}

double penalised(const Race& race, const ContestResult& contest) {
  return contest.score.value.value_or(race.order.rules.failure_score);
}

std::vector<std::optional<double>> scores_by_maze(const Race& race, std::size_t mouse) {
  std::vector<std::vector<double>> scores(race.mazes.size());
  for (const ContestResult& contest : race.results)
    if (contest.mouse == mouse && counts(race, contest)) scores[contest.maze].push_back(penalised(race, contest));
  std::vector<std::optional<double>> means;
  for (const auto& of_maze : scores) means.push_back(mean_if_any(of_maze));
  return means;
}

std::vector<Standing> standings_of(const Race& race) {
  std::vector<Standing> standings;
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse) standings.push_back(standing_of(race, mouse));
  // The mice stand in the order of their names, so a stable sort breaks ties by name.
  std::stable_sort(standings.begin(), standings.end(), [](const Standing& a, const Standing& b) {
    if (a.penalised_mean.has_value() != b.penalised_mean.has_value()) return a.penalised_mean.has_value();
    return a.penalised_mean < b.penalised_mean;
  });
  return standings;
}

}  // namespace labmouse
