#include "labmouse/lab/standings/standings.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "labmouse/lab/standings/mouse_figures.hpp"

namespace labmouse {
namespace {

Standing standing_of(const Race& race, std::size_t mouse) {
  Standing standing;
  standing.mouse = mouse;
  std::vector<double> all, solved, ratios;
  for (const ContestResult& contest : race.results) {
    if (contest.mouse != mouse || !counts(race, contest)) continue;
    ++standing.runs;
    if (contest.counted) all.push_back(*contest.counted);
    if (!contest.score) continue;
    ++standing.solved;
    solved.push_back(*contest.score);
    if (contest.ratio) ratios.push_back(*contest.ratio);
  }
  std::vector<double> by_maze;
  for (const auto& score : scores_by_maze(race, mouse))
    if (score) by_maze.push_back(*score);
  standing.mazes = static_cast<int>(by_maze.size());
  standing.mean_all = mean_if_any(all);
  standing.interval = bootstrap_interval(by_maze, race.order.seed);
  standing.mean_solved = mean_if_any(solved);
  standing.mean_ratio = mean_if_any(ratios);
  return standing;
}

}  // namespace

std::vector<std::optional<double>> scores_by_maze(const Race& race, std::size_t mouse) {
  std::vector<std::vector<double>> scores(race.mazes.size());
  for (const ContestResult& contest : race.results)
    if (contest.mouse == mouse && counts(race, contest) && contest.counted)
      scores[contest.maze].push_back(*contest.counted);
  std::vector<std::optional<double>> means;
  for (const auto& of_maze : scores) means.push_back(mean_if_any(of_maze));
  return means;
}

std::vector<Standing> standings_of(const Race& race) {
  std::vector<Standing> standings;
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse) standings.push_back(standing_of(race, mouse));
  const bool completeness = !race.world().failure_score();
  const std::string_view tie = race.world().tie_breaker();
  const auto rank = [&](const Standing& standing) {
    return std::tuple(completeness ? -standing.solved : 0, !standing.mean_all.has_value(),
                      standing.mean_all.value_or(0.0), tie.empty() ? std::nullopt : mean_solved(race, standing, tie));
  };
  // The mice stand in the order of their names, so a stable sort breaks ties by name.
  std::stable_sort(standings.begin(), standings.end(),
                   [&](const Standing& a, const Standing& b) { return rank(a) < rank(b); });
  return standings;
}

Value figure_of(const Race& race, const Standing& standing, std::string_view key) {
  for (const MouseField& field : race.world().fields().mouse)
    if (field.key == key) return field.of(race, standing);
  return {};
}

}  // namespace labmouse
