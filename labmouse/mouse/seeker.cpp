#include "labmouse/mouse/seeker.hpp"

#include <algorithm>
#include <optional>

namespace labmouse {

Seeker::Seeker(const Briefing& briefing, TieOrder ties)
    : Explorer(briefing),
      moves_(briefing.size, briefing.motion.longest),
      seen_cells_(briefing.size, Python::v3_5, CellKey::column_row),
      routes_(briefing.size, briefing.motion.longest, ties),
      optimistic_(briefing.size, briefing.motion) {
  plan_.reserve(static_cast<std::size_t>(briefing.size.area()));
}

Action Seeker::explore() {
  if (goal_entered()) {
    plan_.clear();
    return Action::reset();
  }
  // Standing on a goal without having entered it: the start is one. A step has to end there.
  if (briefing().goals.contains(pose().cell)) return Action::step(0, 0);
  look();
  if (plan_.empty()) plan_to_cheapest();
  if (!plan_.empty()) return follow();
  optimistic_.fill(knowledge().possible(), briefing().goals);
  return optimistic_step(optimistic_);
}

Action Seeker::race() {
  if (briefing().goals.contains(pose().cell)) return Action::step(0, 0);
  if (plan_.empty()) plan_to_goal();
  return follow();
}

/// Keeps the moves and the cells that the present reading shows.
void Seeker::look() {
  moves_.learn(pose(), seen());
  seen_cells_.insert(pose().cell);
  for (const int side : {-1, 0, 1})
    for (int away = 1; away <= seen().towards(side); ++away)
      seen_cells_.insert(neighbour(pose().cell, turned(pose().heading, side), away));
}

void Seeker::plan_to_cheapest() {
  routes_.grow(moves_, pose());
  std::optional<Cell> cheapest;
  seen_cells_.for_each([&](Cell cell) {
    if (!visited().contains(cell) && (!cheapest || cost(cell) < cost(*cheapest))) cheapest = cell;
  });
  if (cheapest) plan_to(*cheapest);
}

void Seeker::plan_to_goal() {
  routes_.grow(moves_, pose());
  const auto found = routes_.found();
  plan_to(*std::find_if(found.begin(), found.end(), [&](Cell cell) { return briefing().goals.contains(cell); }));
}

void Seeker::plan_to(Cell target) {
  for (Cell cell = target; routes_.distance(cell) > 0; cell = routes_.before(cell)) plan_.push_back(cell);
}

Action Seeker::follow() {
  const Move move = move_between(pose().cell, plan_.back());
  plan_.pop_back();
  return move_in(pose().heading, move.direction, move.cells);
}

}  // namespace labmouse
