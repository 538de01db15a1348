#include "labmouse/contest/score.hpp"

namespace labmouse {

Score score(const RunRecord& record, const Rules& rules) {
  Score result;
  result.outcome = record.outcome;
  for (const StepRecord& step : record.steps) ++(step.run == Run::speed ? result.speed_steps : result.search_steps);
  if (record.outcome == Outcome::finished) result.value = score_of(result.search_steps, result.speed_steps, rules);
  return result;
}

}  // namespace labmouse
