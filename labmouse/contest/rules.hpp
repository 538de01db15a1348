// The numbers of the world of steps. docs/reference/worlds-and-rules.md has the rules in words.
#pragma once

namespace labmouse {

struct Rules {
  /// Steps over both runs; the step after the last ends the contest without a score.
  int budget = 1000;
  /// So many steps of the search run count as one of the speed run.
  int search_factor = 30;
  /// The longest movement of one step, in cells; longer ones are cut to it.
  int stride = 3;
  /// What a failed contest counts in means over all contests (the fourth report's habit).
  double failure_score = 100.0;

  friend constexpr bool operator==(const Rules&, const Rules&) = default;
};

}  // namespace labmouse
