#include "labmouse/contest/missteps.hpp"

namespace labmouse {
namespace {

bool is_cut(const Action& action, const Rules& rules) {
  return action.kind == Action::Kind::step && (action.movement > rules.stride || action.movement < -rules.stride);
}

/// Whether a reset did nothing. One that is performed begins the speed run, be it that no step of it was left.
bool is_idle_reset(const RunRecord& record, std::size_t position) {
  const StepRecord& step = record.steps[position];
  if (step.action.kind != Action::Kind::reset) return false;
  const bool last = position + 1 == record.steps.size();
  const bool speed_run_follows =
      last ? record.outcome == Outcome::speed_run_unfinished : record.steps[position + 1].run == Run::speed;
  return step.run == Run::speed || !speed_run_follows;
}

void count(MisstepCount& kind, bool is_one, int step) {
  if (is_one && kind.steps++ == 0) kind.first = step;
}

}  // namespace

Missteps missteps_of(const RunRecord& record, const Rules& rules) {
  Missteps missteps;
  for (std::size_t i = 0; i < record.steps.size(); ++i) {
    const StepRecord& step = record.steps[i];
    count(missteps.blocked, step.blocked, step.step);
    count(missteps.void_rotations, has_void_rotation(step.action), step.step);
    count(missteps.cut_movements, is_cut(step.action, rules), step.step);
    count(missteps.idle_resets, is_idle_reset(record, i), step.step);
  }
  return missteps;
}

}  // namespace labmouse
