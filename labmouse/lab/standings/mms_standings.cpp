#include "labmouse/lab/standings/mms_standings.hpp"

#include <algorithm>

#include "labmouse/lab/records/mms_fields.hpp"

namespace labmouse {
namespace {

std::optional<double> mean_if_any(std::span<const double> values) {
  return values.empty() ? std::nullopt : std::optional(mean(values));
}

/// The value over the best possible one. In a maze that starts in its goal that is 0, and so is the value of a mouse
/// that does nothing more than needed.
std::optional<double> ratio(const std::optional<double>& value, const std::optional<double>& best) {
  if (!value || !best || *best <= 0.0) return std::nullopt;
  return *value / *best;
}

/// What the runs of one mouse add up to.
struct Sums {
  std::vector<double> scores, solved_scores, best_runs, ratios, run_ratios, totals, seconds;

  void add(const MmsRace& race, const MmsResult& result) {
    const MmsStatistics& statistics = result.run.statistics;
    scores.push_back(decimal(statistics.score));
    totals.push_back(total(statistics));
    seconds.push_back(result.run.seconds);
    if (!statistics.solved) return;
    solved_scores.push_back(decimal(statistics.score));
    best_runs.push_back(*best_run(statistics));
    if (const auto share = score_ratio(race, result)) ratios.push_back(*share);
    if (const auto share = run_ratio(race, result)) run_ratios.push_back(*share);
  }
};

MmsStanding standing_of(const MmsRace& race, std::size_t mouse) {
  MmsStanding standing;
  standing.mouse = mouse;
  Sums sums;
  for (const MmsResult& result : race.results) {
    if (result.mouse != mouse || !result.done) continue;
    ++standing.outcomes[static_cast<std::size_t>(result.run.outcome)];
    standing.lines += result.run.lines;
    standing.invalid_lines += result.run.invalid_lines;
    if (counts(race, result)) sums.add(race, result);
  }
  standing.runs = static_cast<int>(sums.scores.size());
  standing.solved = static_cast<int>(sums.solved_scores.size());
  standing.mean_score = mean_if_any(sums.scores);
  standing.interval = bootstrap_interval(sums.scores, race.order.seed);
  standing.mean_solved_score = mean_if_any(sums.solved_scores);
  standing.mean_best_run = mean_if_any(sums.best_runs);
  standing.mean_ratio = mean_if_any(sums.ratios);
  standing.mean_run_ratio = mean_if_any(sums.run_ratios);
  standing.mean_total = mean_if_any(sums.totals);
  standing.mean_seconds = mean_if_any(sums.seconds);
  return standing;
}

}  // namespace

bool counts(const MmsRace& race, const MmsResult& result) {
  return result.done && race.bounds[result.maze].run.has_value();
}

std::optional<double> score_ratio(const MmsRace& race, const MmsResult& result) {
  const MmsStatistics& statistics = result.run.statistics;
  if (!statistics.solved) return std::nullopt;
  return ratio(decimal(statistics.score), race.bounds[result.maze].score);
}

std::optional<double> run_ratio(const MmsRace& race, const MmsResult& result) {
  return ratio(best_run(result.run.statistics), race.bounds[result.maze].run);
}

std::vector<MmsStanding> mms_standings_of(const MmsRace& race) {
  std::vector<MmsStanding> standings;
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse) standings.push_back(standing_of(race, mouse));
  // The mice stand in the order of their names, so a stable sort breaks ties by name.
  std::stable_sort(standings.begin(), standings.end(), [](const MmsStanding& a, const MmsStanding& b) {
    if (a.mean_score.has_value() != b.mean_score.has_value()) return a.mean_score.has_value();
    return a.mean_score < b.mean_score;
  });
  return standings;
}

}  // namespace labmouse
