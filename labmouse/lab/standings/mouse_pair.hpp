// Two mice in the same mazes: which is better?
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "labmouse/lab/numbers/statistics.hpp"
#include "labmouse/lab/numbers/verdict.hpp"
#include "labmouse/lab/standings/maze_scores.hpp"

namespace labmouse {

/// How often both finished, where the world gives failed contests no score.
struct FinishRates {
  MazeScores mouse, against;  ///< over the mazes that both ran
  /// Of the shares of failed contests in each maze, 0 to 1: below 0, the mouse finishes more often.
  PairedDifference failed;
  /// Of the mean scores of the finished contests, in mazes in which both finished one. Says nothing of failures, and so
  /// has no verdict.
  PairedDifference finished_only;
};

/// Differences are of the first mouse minus the other one: below 0, the first is better. A maze counts where both have
/// a contest that counts.
struct MousePair {
  std::vector<std::size_t> mazes;   ///< those that count, by position
  std::vector<double> differences;  ///< of the mean scores in each, failed contests at the limit score
  PairedDifference scores;          ///< statistics of `differences`
  bool has_rates = false;
  FinishRates rates;  ///< only if `has_rates`
};

/// @param has_rates Whether failed contests have no score in this world.
MousePair pair_of(std::span<const MazeScores> mouse, std::span<const MazeScores> against, bool has_rates,
                  std::uint64_t seed);

/// All differences that get a verdict, in one list: for each pair the scores and, if it has them, the failure rates.
std::vector<PairedDifference> judged(std::span<const MousePair> pairs);

/// The verdicts of a pair.
struct PairVerdicts {
  TestVerdict scores = TestVerdict::too_few;
  TestVerdict rates = TestVerdict::too_few;  ///< no_difference where there are no rates
  double scores_p = 1.0, rates_p = 1.0;      ///< corrected
};

/// Of all pairs of one output, corrected for their number.
std::vector<PairVerdicts> verdicts_of(std::span<const MousePair> pairs);

}  // namespace labmouse
