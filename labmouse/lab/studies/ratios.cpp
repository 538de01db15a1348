#include "labmouse/lab/studies/ratios.hpp"

#include <algorithm>
#include <optional>

#include "labmouse/lab/standings/mouse_figures.hpp"
#include "labmouse/lab/standings/standings.hpp"

namespace labmouse {
namespace {

using ByMaze = std::vector<std::optional<double>>;

/// The mean of a figure in each maze, over the contests with a score; nothing where there are none.
ByMaze figures_by_maze(const Race& race, std::size_t mouse, std::string_view key) {
  std::vector<std::vector<double>> numbers(race.mazes.size());
  Standing standing;
  standing.mouse = mouse;
  for_each_finished(race, standing, [&](const ContestResult& contest) {
    if (const auto number = number_of(figure_of(race, contest, key))) numbers[contest.maze].push_back(*number);
  });
  ByMaze means;
  for (const auto& of_maze : numbers) means.push_back(mean_if_any(of_maze));
  return means;
}

void add(std::string_view figure, const ByMaze& mouse, const ByMaze& against, std::uint64_t seed,
         std::vector<FigureRatio>& ratios) {
  std::vector<double> values, others;
  for (std::size_t maze = 0; maze < mouse.size(); ++maze) {
    if (!mouse[maze] || !against[maze]) continue;
    values.push_back(*mouse[maze]);
    others.push_back(*against[maze]);
  }
  const auto above = [](const std::vector<double>& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double number) { return number > 0.0; });
  };
  if (values.empty() || !above(values) || !above(others)) return;
  PairedRatio found = paired_ratio(values, others, seed);
  found.interval.low = std::max(0.0, found.interval.low);  // all figures are above 0
  ratios.push_back({figure, static_cast<int>(values.size()), found});
}

}  // namespace

std::vector<FigureRatio> ratios_of(const Study& study, const Comparison& comparison) {
  const Race& race = study.race;
  std::vector<FigureRatio> ratios;
  add("score", scores_by_maze(race, comparison.mouse), scores_by_maze(race, comparison.against), race.order.seed,
      ratios);
  for (const ComparedFigure& figure : race.world().traits().fields->compared)
    add(figure.name, figures_by_maze(race, comparison.mouse, figure.key),
        figures_by_maze(race, comparison.against, figure.key), race.order.seed, ratios);
  return ratios;
}

}  // namespace labmouse
