#include "labmouse/strategies/wanderer.hpp"

#include <cassert>

namespace labmouse {

Wanderer::Wanderer(const Briefing& briefing, double coverage, SearchMethod method, TieOrder order)
    : Explorer(briefing),
      dice_(briefing.seed),
      cells_to_visit_(coverage * briefing.size.area()),
      near_walls_(briefing.start.cell),
      search_(briefing.size, method, order) {
  moves_.reserve(static_cast<std::size_t>(briefing.size.area()));
}

std::span<const Counter> Wanderer::counters() const {
  return planned_ ? std::span<const Counter>(counters_) : std::span<const Counter>();
}

Action Wanderer::explore() {
  near_walls_.arrive(pose(), seen());
  const bool covered = visited().count() >= cells_to_visit_;
  return goal_entered() && covered ? Action::reset() : wander();
}

Action Wanderer::random_step() {
  for (;;) {
    const int quarters = dice_.below(3) - 1;
    const int movement = dice_.below(briefing().motion.longest + 1);
    if (seen().towards(quarters) >= movement) return Action::step(90 * quarters, movement);
  }
}

Action Wanderer::race() {
  if (!planned_) plan();
  // The start is a goal: a step has to end there.
  if (next_move_ == moves_.size()) return Action::step(0, 0);
  const Move& move = moves_[next_move_++];
  return move_in(pose().heading, move.direction, move.cells);
}

void Wanderer::plan() {
  [[maybe_unused]] const bool way = search_.search(near_walls_.open(), pose(), briefing().goals);
  assert(way);
  merge_strides(search_.way(), briefing().motion.longest, moves_);
  counters_ = {Counter{"nodes expanded", search_.expanded()}, Counter{"nodes found", search_.found()}};
  planned_ = true;
}

}  // namespace labmouse
