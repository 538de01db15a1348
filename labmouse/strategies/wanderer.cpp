#include "labmouse/strategies/wanderer.hpp"

#include <algorithm>

namespace labmouse {
namespace {

/// Largest number of recorded steps: more than any contest of the reports has.
constexpr int most_walks = 10'000;

}  // namespace

Wanderer::Wanderer(const Briefing& briefing, const Settings& settings)
    : Explorer(briefing),
      rng_(briefing.seed),
      cells_to_mark_(settings.real(wanderers_coverage.name) * briefing.size.area()),
      passages_(briefing.size, std::min(briefing.budget, most_walks)),
      search_(briefing.size, passages_.most_edges(), search_method(settings.choice(wanderers_search.name))) {
  moves_.reserve(static_cast<std::size_t>(briefing.size.area()));
}

StrategyReport Wanderer::report() { return planned_ ? StrategyReport{.counters = counters_} : StrategyReport(); }

// The last step is drawn and mapped, but replaced by a reset.
Action Wanderer::explore() {
  const Action step = wander();
  if (step.movement > 0) passages_.walk(pose().cell, after(pose(), step).cell);
  const bool covered = goal_marked_ && marked_.count() >= cells_to_mark_;
  return covered && goal_entered() ? Action::reset() : step;
}

int Wanderer::draw() {
  marked_.insert(pose().cell);
  goal_marked_ |= briefing().goals.contains(pose().cell);
  return rng_.below(3) - 1;
}

Action Wanderer::draw_a_free_cell() {
  for (;;)
    if (const int quarters = draw(); is_free(quarters)) return Action::step(90 * quarters, 1);
}

// Without a way to a goal in the map, the mouse stays at the start.
Action Wanderer::race() {
  if (!planned_) plan();
  if (next_move_ == moves_.size()) return Action::step(0, 0);
  const Move& move = moves_[next_move_++];
  return move_in(pose().heading, move.direction, move.cells);
}

void Wanderer::plan() {
  search_.search(passages_, briefing().start.cell, briefing().goals);
  merge_strides(search_.way(), briefing().motion.longest, moves_);
  counters_ = {Counter{"nodes found", search_.found()}};
  planned_ = true;
}

}  // namespace labmouse
