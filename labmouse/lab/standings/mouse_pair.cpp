#include "labmouse/lab/standings/mouse_pair.hpp"

#include <optional>

namespace labmouse {
namespace {

void add(const MazeScores& maze, MazeScores& sum) {
  sum.contests += maze.contests;
  sum.finished += maze.finished;
  sum.sum += maze.sum;
  sum.finished_sum += maze.finished_sum;
}

FinishRates rates_of(std::span<const MazeScores> mouse, std::span<const MazeScores> against,
                     const std::vector<std::size_t>& mazes, std::uint64_t seed) {
  FinishRates rates;
  std::vector<double> failed, finished_only;
  for (const std::size_t maze : mazes) {
    const MazeScores &one = mouse[maze], &other = against[maze];
    add(one, rates.mouse);
    add(other, rates.against);
    failed.push_back(*one.failed_share() - *other.failed_share());
    if (one.finished > 0 && other.finished > 0) finished_only.push_back(*one.finished_mean() - *other.finished_mean());
  }
  rates.failed = paired_difference(failed, seed);
  rates.finished_only = paired_difference(finished_only, seed);
  return rates;
}

}  // namespace

MousePair pair_of(std::span<const MazeScores> mouse, std::span<const MazeScores> against, bool has_rates,
                  std::uint64_t seed) {
  MousePair pair;
  for (std::size_t maze = 0; maze < mouse.size(); ++maze) {
    const std::optional<double> one = mouse[maze].mean(), other = against[maze].mean();
    if (!one || !other) continue;
    pair.mazes.push_back(maze);
    pair.differences.push_back(*one - *other);
  }
  pair.scores = paired_difference(pair.differences, seed);
  pair.has_rates = has_rates;
  if (has_rates) pair.rates = rates_of(mouse, against, pair.mazes, seed);
  return pair;
}

std::vector<PairedDifference> judged(std::span<const MousePair> pairs) {
  std::vector<PairedDifference> all;
  for (const MousePair& pair : pairs) {
    all.push_back(pair.scores);
    if (pair.has_rates) all.push_back(pair.rates.failed);
  }
  return all;
}

std::vector<PairVerdicts> verdicts_of(std::span<const MousePair> pairs) {
  const std::vector<PairedDifference> all = judged(pairs);
  std::vector<double> p;
  for (const PairedDifference& found : all) p.push_back(found.p);
  p = holm(p);
  std::vector<PairVerdicts> verdicts;
  std::size_t next = 0;
  for (const MousePair& pair : pairs) {
    PairVerdicts of;
    of.scores_p = p[next++];
    of.scores = verdict_of(pair.scores, of.scores_p);
    of.rates_p = pair.has_rates ? p[next++] : 1.0;
    of.rates = pair.has_rates ? verdict_of(pair.rates.failed, of.rates_p) : TestVerdict::no_difference;
    verdicts.push_back(of);
  }
  return verdicts;
}

}  // namespace labmouse
