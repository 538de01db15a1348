// Ranks mice by their shares of the best possible score. Mice without a significant difference share a rank.
#pragma once

#include <string>
#include <vector>

#include "labmouse/lab/numbers/interval.hpp"
#include "labmouse/lab/numbers/verdict.hpp"

namespace labmouse {

/// What a mouse scored in each maze of the examination: shares of the best possible score, 0 to 1.
struct MouseShares {
  std::string name;
  std::vector<double> shares;
};

/// How ranks are given, as a sentence for readers.
inline constexpr std::string_view ranking_rule =
    "Mice are sorted by their mean share of the best possible score in the examination: the score of a mouse that "
    "knows "
    "the maze, divided by the mouse's; 0 for a contest that is not finished. The best mouse has rank 1. All "
    "mice below it share this rank, up to the first one that is significantly worse than it; the next rank begins "
    "there. "
    "Significant: sign-flip test of the paired differences at 5 %, with Bonferroni's correction over all comparisons "
    "of "
    "one mouse, and an interval without 0.";

struct RankedMouse {
  std::string name;
  std::size_t place = 0;  ///< position in the list that was ranked
  int rank = 0;           ///< from 1; mice of one group share it
  double mean = 0.0;
  Interval interval;  ///< of the mean, over the mazes
};

/// A mouse compared with another one.
struct RankedPair {
  double difference = 0.0;  ///< of the mean shares: above 0, the mouse is better
  Interval interval;
  TestVerdict verdict = TestVerdict::too_few;  ///< on the mouse
};

struct Ranking {
  std::vector<RankedMouse> mice;               ///< best first; equal means by name
  std::vector<std::vector<RankedPair>> pairs;  ///< of each with each, in that order; the diagonal means nothing
};

/// @param all of each mouse in the same mazes, at least one.
Ranking rank_mice(const std::vector<MouseShares>& all);

/// Which mice share a rank, a line for each such rank: "Rank 1: ariadne cannot be told apart from flood, certify."; and
/// a line that more mazes are needed if all share it. Empty if each mouse has a rank of its own.
std::string groups_text(const Ranking& ranking);

}  // namespace labmouse
