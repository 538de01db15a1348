// What a contest is worth: a function of its record, so that a record written by a real robot scores by the same code.
#pragma once

#include <optional>

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"

namespace labmouse {

struct Score {
  Outcome outcome = Outcome::out_of_steps;
  /// Steps of each run; the reset's own step belongs to the search run. What was not finished is counted as far as it
  /// went.
  int search_steps = 0;
  int speed_steps = 0;
  /// Speed steps plus search steps / factor; nothing where the contest was not finished.
  std::optional<double> value;
};

/// The formula itself: one division and one addition, so every platform rounds alike.
constexpr double score_of(int search_steps, int speed_steps, const Rules& rules) {
  return speed_steps + static_cast<double>(search_steps) / rules.search_factor;
}

Score score(const RunRecord& record, const Rules& rules);

}  // namespace labmouse
