// The numbers of the world of steps. docs/reference/worlds-and-rules.md explains the rules.
#pragma once

namespace labmouse {

/// The rules of a contest in steps.
struct Rules {
  /// Steps over both runs; the step after the last ends the contest without a score.
  int budget = 1000;
  /// So many steps of the search run count as one of the speed run.
  int search_factor = 30;
  /// The longest movement of one step, in cells; longer ones are cut to it.
  int stride = 3;
  /// Score of an unfinished contest in means over all contests.
  double failure_score = 100.0;

  friend constexpr bool operator==(const Rules&, const Rules&) = default;
};

}  // namespace labmouse
