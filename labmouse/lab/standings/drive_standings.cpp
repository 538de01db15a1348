#include "labmouse/lab/standings/drive_standings.hpp"

#include <algorithm>

namespace labmouse {
namespace {

std::optional<double> mean_if_any(std::span<const double> values) {
  return values.empty() ? std::nullopt : std::optional(mean(values));
}

double seconds(MazeTime time) { return static_cast<double>(time) / 1e6; }

/// What the contests of one mouse add up to.
struct Sums {
  std::vector<double> scores, ratios, searches, bests, excesses, starts;
  std::vector<std::vector<double>> by_maze;

  void add(const DriveRace& race, const DriveResult& result) {
    const MazeTime value = *result.score.value();
    scores.push_back(seconds(value));
    by_maze[result.maze].push_back(seconds(value));
    // A bonus would leave little or nothing to compare; all have it.
    const MazeTime bonus = race.order.rules.untouched_bonus;
    if (const MazeTime bound = *race.bounds[result.maze].score + bonus; bound > 0)
      ratios.push_back(static_cast<double>(value + bonus) / static_cast<double>(bound));
    searches.push_back(seconds(result.search));
    bests.push_back(seconds(*result.best));
    if (const auto excess = excess_of(race, result)) excesses.push_back(*excess);
    starts.push_back(result.starts);
  }
};

DriveStanding standing_of(const DriveRace& race, std::size_t mouse) {
  DriveStanding standing;
  standing.mouse = mouse;
  Sums sums;
  sums.by_maze.resize(race.mazes.size());
  std::vector<bool> mazes(race.mazes.size());
  for (const DriveResult& result : race.results) {
    if (result.mouse != mouse || !counts(race, result)) continue;
    ++standing.runs;
    mazes[result.maze] = true;
    standing.decisions += result.decisions;
    standing.replanned += result.replanned;
    if (!result.score.value() || !result.best) continue;
    ++standing.scored;
    sums.add(race, result);
    const auto& fastest = race.bounds[result.maze].fastest;
    if (fastest && *result.best <= *fastest) ++standing.optimal;
    if (result.proven) ++standing.proven;
  }
  std::vector<double> means;
  for (const auto& scores : sums.by_maze)
    if (const auto score = mean_if_any(scores)) means.push_back(*score);
  standing.mazes = static_cast<int>(std::count(mazes.begin(), mazes.end(), true));
  standing.mean_score = mean_if_any(sums.scores);
  standing.interval = bootstrap_interval(means, race.order.seed);
  standing.mean_ratio = mean_if_any(sums.ratios);
  standing.mean_search = mean_if_any(sums.searches);
  standing.mean_best = mean_if_any(sums.bests);
  standing.mean_excess = mean_if_any(sums.excesses);
  standing.mean_starts = mean_if_any(sums.starts);
  return standing;
}

}  // namespace

bool counts(const DriveRace& race, const DriveResult& result) {
  return result.done && race.bounds[result.maze].score.has_value();
}

std::optional<double> excess_of(const DriveRace& race, const DriveResult& result) {
  const auto& fastest = race.bounds[result.maze].fastest;
  if (!result.best || !fastest || *fastest == 0) return std::nullopt;
  return static_cast<double>(*result.best) / *fastest - 1.0;
}

std::vector<DriveStanding> drive_standings_of(const DriveRace& race) {
  std::vector<DriveStanding> standings;
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse) standings.push_back(standing_of(race, mouse));
  // The mice stand in the order of their names, so a stable sort breaks ties by name.
  std::stable_sort(standings.begin(), standings.end(), [](const DriveStanding& a, const DriveStanding& b) {
    if (a.scored != b.scored) return a.scored > b.scored;
    if (a.mean_score != b.mean_score) return a.mean_score < b.mean_score;
    return a.mean_search < b.mean_search;
  });
  return standings;
}

}  // namespace labmouse
