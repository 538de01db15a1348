#include "labmouse/mouse/explorer.hpp"

#include <cassert>

namespace labmouse {

Explorer::Explorer(const Briefing& briefing)
    : briefing_(briefing),
      knowledge_(briefing.size, briefing.sight),
      pose_(briefing.start),
      to_goal_(briefing.size, briefing.motion) {
  assert(briefing.size.contains(briefing.start.cell) && !briefing.goals.empty());
  visited_.insert(pose_.cell);
}

Action Explorer::decide(const Sighting& seen) {
  if (!knowledge_.learn(pose_, seen)) return Action::forfeit(ForfeitReason::contradiction);
  seen_ = seen;
  const Action action = racing_ ? race() : explore();
  perform(action);
  ++steps_;
  return action;
}

Action Explorer::race() {
  to_goal_.fill(knowledge_.open(), briefing_.goals);
  return step_along(to_goal_, knowledge_.open(), pose_);
}

void Explorer::perform(const Action& action) {
  switch (action.kind) {
    case Action::Kind::step:
      move(action);
      break;
    case Action::Kind::reset:
      assert(goal_entered_ && !racing_);
      pose_ = briefing_.start;
      racing_ = true;
      break;
    case Action::Kind::forfeit:
      break;
  }
}

void Explorer::move(const Action& step) {
  pose_ = after(pose_, step);
  assert(briefing_.size.contains(pose_.cell));
  if (racing_) return;
  visited_.insert(pose_.cell);
  if (briefing_.goals.contains(pose_.cell)) goal_entered_ = true;
}

}  // namespace labmouse
