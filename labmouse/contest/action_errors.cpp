#include "labmouse/contest/action_errors.hpp"

#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {
namespace {

bool is_cut(const Action& action, const Rules& rules) {
  return action.kind == Action::Kind::step && (action.movement > rules.stride || action.movement < -rules.stride);
}

/// Whether a reset did nothing. A reset that is performed begins the speed run, even if no step is left for it.
bool is_idle_reset(const RunRecord& record, std::size_t position) {
  const StepRecord& step = record.steps[position];
  if (step.action.kind != Action::Kind::reset) return false;
  const bool last = position + 1 == record.steps.size();
  const bool speed_run_follows =
      last ? record.outcome == Outcome::speed_run_unfinished : record.steps[position + 1].run == Run::speed;
  return step.run == Run::speed || !speed_run_follows;
}

void count(ActionErrorCount& kind, bool is_one, int step) {
  if (is_one && kind.steps++ == 0) kind.first = step;
}

/// The wall ahead of the mouse, or behind it where it backs, at the place where its movement ended.
Wall wall_at_end(const StepRecord& step, Cell end) {
  const Heading ahead = rotated(step.pose.heading, step.action.rotation);
  return wall_at(end, step.action.movement < 0 ? opposite(ahead) : ahead);
}

}  // namespace

ActionErrors action_errors_of(const RunRecord& record, const Rules& rules) {
  ActionErrors action_errors;
  for (std::size_t i = 0; i < record.steps.size(); ++i) {
    const StepRecord& step = record.steps[i];
    count(action_errors.blocked, step.blocked, step.step);
    count(action_errors.void_rotations, has_void_rotation(step.action), step.step);
    count(action_errors.cut_movements, is_cut(step.action, rules), step.step);
    count(action_errors.idle_resets, is_idle_reset(record, i), step.step);
  }
  return action_errors;
}

int known_wall_hits(const RunRecord& record, Size size) {
  Knowledge known(size);
  int hits = 0;
  for (std::size_t i = 0; i < record.steps.size(); ++i) {
    const StepRecord& step = record.steps[i];
    // A contradiction is learned as nothing; readings of the truth have none.
    static_cast<void>(known.learn(step.pose, step.sighting));
    if (!step.blocked) continue;
    const Pose& end = i + 1 < record.steps.size() ? record.steps[i + 1].pose : record.end;
    if (known.state(wall_at_end(step, end.cell)) == WallState::closed) ++hits;
  }
  return hits;
}

}  // namespace labmouse
