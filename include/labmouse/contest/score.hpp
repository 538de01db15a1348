// Scores the record of a contest in the world of steps. Records of real robots are scored by the same code.
#pragma once

#include <optional>

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"

namespace labmouse {

/// The score of a contest in steps; lower is better.
struct Score {
  Outcome outcome = Outcome::out_of_steps;
  /// Steps of each run; the reset's own step belongs to the search run. An unfinished run counts its steps so far.
  int search_steps = 0;
  int speed_steps = 0;
  /// Speed steps plus search steps / factor; none if the contest was not finished.
  std::optional<double> value;
};

/// The formula itself: one division and one addition, so every platform rounds alike.
/// @param search_steps steps of the search run.
/// @param speed_steps steps of the speed run.
/// @param rules their `search_factor` must not be 0.
/// @return in steps of the speed run.
constexpr double score_of(int search_steps, int speed_steps, const Rules& rules) {
  return speed_steps + static_cast<double>(search_steps) / rules.search_factor;
}

/// Scores a record, of a simulated or a real robot.
/// @param record of a contest in steps.
/// @param rules those of the contest.
/// @return `value` in steps of the speed run; lower is better.
Score score(const RunRecord& record, const Rules& rules);

}  // namespace labmouse
