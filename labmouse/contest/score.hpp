// What a contest is worth: a function of its record, so that a record written by a real robot scores by the same code.
#pragma once

#include <optional>

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"

namespace labmouse {

struct Score {
  Outcome outcome = Outcome::out_of_steps;
  /// Steps of each run; the reset's own step belongs to the exploration. What was not finished is counted as far as it
  /// went.
  int exploration_steps = 0;
  int speed_steps = 0;
  /// Speed steps plus exploration steps / factor; nothing where the contest was not solved.
  std::optional<double> value;
};

/// The formula itself: one division and one addition, so every platform rounds alike.
constexpr double score_of(int exploration_steps, int speed_steps, const Rules& rules) {
  return speed_steps + static_cast<double>(exploration_steps) / rules.exploration_factor;
}

Score score(const RunRecord& record, const Rules& rules);

}  // namespace labmouse
