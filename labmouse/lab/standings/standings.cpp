#include "labmouse/lab/standings/standings.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "labmouse/lab/numbers/maze_interval.hpp"
#include "labmouse/lab/standings/maze_scores.hpp"
#include "labmouse/lab/standings/mouse_figures.hpp"

namespace labmouse {
namespace {

/// A sum and a count of each maze, as `of` makes them.
template <class Of>
std::vector<MazeSum> sums_of(const std::vector<MazeScores>& scores, Of of) {
  std::vector<MazeSum> sums;
  for (const MazeScores& maze : scores) sums.push_back(of(maze));
  return sums;
}

/// Sets the intervals and the mean at the limit. Where failed contests count in the mean over all, that is the same.
void set_intervals(const Race& race, Standing& standing) {
  const std::vector<MazeScores> scores = maze_scores(race, standing.mouse);
  const auto at_limit = sums_of(scores, [](const MazeScores& maze) { return MazeSum{maze.sum, 1.0 * maze.contests}; });
  const ScorePlace place = race.world().traits().score_place;
  const auto interval = [&](const std::vector<MazeSum>& sums, const std::optional<double>& mean) {
    if (!mean) return Interval();
    const Interval found = interval_of(sums, race.order.seed);
    return including(among_scores(found, place), *mean);
  };
  const bool counts_failures = race.world().traits().failure_score.has_value();
  if (standing.runs > 0) standing.mean_at_limit = counts_failures ? standing.mean_all : mean_of(at_limit);
  standing.interval_at_limit = interval(at_limit, standing.mean_at_limit);
  standing.interval = counts_failures ? standing.interval_at_limit
                                      : interval(sums_of(scores,
                                                         [](const MazeScores& maze) {
                                                           return MazeSum{maze.finished_sum, 1.0 * maze.finished};
                                                         }),
                                                 standing.mean_all);
  standing.finished_share = share_interval(sums_of(scores, [](const MazeScores& maze) {
    return MazeSum{1.0 * maze.finished, 1.0 * maze.contests};
  }));
}

void set_share(const Race& race, Standing& standing) {
  std::vector<MazeSum> sums(race.mazes.size());
  for (const ContestResult& contest : race.results) {
    const auto share = contest.mouse == standing.mouse ? share_of_best(race, contest) : std::nullopt;
    if (!share) continue;
    sums[contest.maze].sum += *share;
    sums[contest.maze].count += 1.0;
  }
  if (std::all_of(sums.begin(), sums.end(), [](const MazeSum& sum) { return sum.count == 0.0; })) return;
  standing.mean_share = mean_of(sums);
  const Interval found = interval_of(sums, race.order.seed);
  standing.share = including({std::max(found.low, 0.0), std::min(found.high, 1.0)}, *standing.mean_share);
}

Standing standing_of(const Race& race, std::size_t mouse) {
  Standing standing;
  standing.mouse = mouse;
  std::vector<double> all, finished, ratios;
  for (const ContestResult& contest : race.results) {
    if (contest.mouse != mouse || !counts(race, contest)) continue;
    ++standing.runs;
    if (contest.counted) all.push_back(*contest.counted);
    if (!contest.score) continue;
    ++standing.finished;
    finished.push_back(*contest.score);
    if (contest.ratio) ratios.push_back(*contest.ratio);
  }
  const auto by_maze = scores_by_maze(race, mouse);
  standing.mazes = static_cast<int>(std::count_if(by_maze.begin(), by_maze.end(), [](auto& score) { return score; }));
  standing.mean_all = mean_if_any(all);
  standing.mean_finished = mean_if_any(finished);
  standing.mean_ratio = mean_if_any(ratios);
  set_intervals(race, standing);
  set_share(race, standing);
  return standing;
}

}  // namespace

std::optional<double> share_of_best(const Race& race, const ContestResult& contest) {
  if (!race.world().traits().has_ratio || !counts(race, contest) ||
      contest.score.has_value() != contest.ratio.has_value())
    return std::nullopt;
  if (!contest.ratio) return 0.0;
  return *contest.ratio <= 1.0 ? 1.0 : 1.0 / *contest.ratio;
}

Interval among_scores(const Interval& interval, const ScorePlace& place) {
  // + 0.0 turns -0.0 into 0.
  return {std::max(interval.low, place.least + 0.0), std::min(interval.high, place.most)};
}

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
  const bool completeness = !race.world().traits().failure_score;
  const std::string_view tie = race.world().traits().tie_breaker;
  const auto rank = [&](const Standing& standing) {
    return std::tuple(completeness ? -standing.finished : 0, !standing.mean_all.has_value(),
                      standing.mean_all.value_or(0.0), tie.empty() ? std::nullopt : mean_finished(race, standing, tie));
  };
  // The mice stand in the order of their names, so a stable sort breaks ties by name.
  std::stable_sort(standings.begin(), standings.end(),
                   [&](const Standing& a, const Standing& b) { return rank(a) < rank(b); });
  return standings;
}

Value figure_of(const Race& race, const Standing& standing, std::string_view key) {
  for (const MouseField& field : race.world().traits().fields->mouse)
    if (field.key == key) return field.of(race, standing);
  return {};
}

}  // namespace labmouse
