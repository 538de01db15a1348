#include "labmouse/mouse/seeker.hpp"

namespace labmouse {

Seeker::Seeker(const Briefing& briefing, TieOrder ties)
    : Explorer(briefing),
      ties_(ties),
      routes_(briefing.size, briefing.motion.longest, ties),
      optimistic_(briefing.size, briefing.motion) {}

Action Seeker::explore() {
  if (goal_entered()) return Action::reset();
  // Standing on a goal without having entered it: the start is one. A step has to end there.
  if (briefing().goals.contains(pose().cell)) return Action::step(0, 0);
  routes_.grow(knowledge().open(), pose());
  if (const auto target = choose()) {
    const Move move = move_between(pose().cell, routes_.first_towards(*target));
    return move_in(pose().heading, move.direction, move.cells);
  }
  optimistic_.fill(knowledge().possible(), briefing().goals);
  return optimistic_step(optimistic_);
}

}  // namespace labmouse
