#include "labmouse/contest/score.hpp"

namespace labmouse {

Score score(const RunRecord& record, const Rules& rules) {
  Score result;
  result.outcome = record.outcome;
  for (const StepRecord& step : record.steps)
    ++(step.run == Run::speed ? result.speed_steps : result.exploration_steps);
  if (record.outcome == Outcome::solved) result.value = score_of(result.exploration_steps, result.speed_steps, rules);
  return result;
}

}  // namespace labmouse
